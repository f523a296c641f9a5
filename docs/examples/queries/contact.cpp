#include <pelt/surface.hpp>

// Where, in which direction and how far to push `a`, for each patch. Create the surfaces once.
std::vector<pelt::ContactPatch> pushes(pelt::Pose& a, const pelt::Surface& surface_a, pelt::Pose& b,
                                       const pelt::Surface& surface_b, pelt::Scratch& scratch) {
  std::vector<pelt::Contact> contacts;
  pelt::collide(a, b, scratch, contacts);
  pelt::ContactGeometry geometry;
  pelt::describe_contacts(a, surface_a, b, surface_b, contacts, scratch, geometry);
  return geometry.patches;  // point, normal, depth, joints of both sides
}
