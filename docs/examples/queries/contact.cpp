#include <pelt/surface.hpp>

// Where, in which direction and how far to push `a`, for each patch.
std::vector<pelt::ContactPatch> pushes(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch) {
  std::vector<pelt::Contact> contacts;
  pelt::collide(a, b, scratch, contacts);
  pelt::ContactGeometry geometry;
  pelt::describe_contacts(a, b, contacts, scratch, geometry);
  return geometry.patches;  // point, normal, depth, joints of both sides
}
