#include <pelt/self.hpp>
#include <pelt/surface.hpp>

// A filter for what the animation adds: it leaves out triangles that share a vertex, and pairs that
// already intersect at rest. Create it once. `rest` is in the rest pose.
pelt::Result<pelt::SelfFilter> only_new(pelt::Pose& rest, pelt::Scratch& scratch) {
  pelt::SelfFilterOptions options;
  options.rings = 1;
  const auto neighbours = pelt::build_self_filter(rest.model(), options);
  if (!neighbours) return neighbours;
  std::vector<pelt::Contact> at_rest;
  pelt::self_collide(rest, *neighbours, scratch, at_rest);
  options.at_rest = at_rest;
  return pelt::build_self_filter(rest.model(), options);
}

// Where the character cuts through itself. `left_out` tells how many pairs each filter left out.
std::vector<pelt::ContactPatch> cuts(pelt::Pose& pose, const pelt::SelfFilter& filter,
                                     pelt::Scratch& scratch, pelt::LeftOut& left_out) {
  std::vector<pelt::Contact> contacts;
  left_out = pelt::self_collide(pose, filter, scratch, contacts).left_out;
  pelt::ContactGeometry geometry;
  pelt::describe_contacts(pose, contacts, scratch, geometry);
  return geometry.patches;  // point, normal, depth, joints of both sides
}
