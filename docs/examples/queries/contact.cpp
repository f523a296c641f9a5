#include <pelt/contact.hpp>

// Where, in which direction and how far to push `a`, for each region. Create the surfaces once.
std::vector<pelt::ContactRegion> pushes(pelt::Pose& a, const pelt::Surface& surface_a,
                                        pelt::Pose& b, const pelt::Surface& surface_b,
                                        pelt::Scratch& scratch) {
  std::vector<pelt::Contact> contacts;
  pelt::collide(a, b, scratch, contacts);
  pelt::ContactGeometry geometry;
  pelt::describe_contacts(a, surface_a, b, surface_b, contacts, scratch, geometry);
  return geometry.regions;  // point, normal, depth, joints of both sides
}
