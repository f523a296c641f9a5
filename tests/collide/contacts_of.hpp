#pragma once

/// The contacts of two poses, by a query and by brute force.

#include "support/skinned_shapes.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <pelt/collide.hpp>

#include <cstdint>
#include <vector>

namespace pelt::test {

inline std::vector<Contact> contacts_of(Pose& a, Pose& b, Scratch& scratch) {
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  return contacts;
}

inline std::vector<Contact> brute_force(const Shape& a, const Pose& pose_a, const Shape& b,
                                        const Pose& pose_b) {
  std::vector<Vec3> positions_a(a.rest_positions.size()), positions_b(b.rest_positions.size());
  posed_vertices(pose_a, positions_a);
  posed_vertices(pose_b, positions_b);
  std::vector<Contact> contacts;
  methods::brute_force_collide(a.triangles, positions_a, b.triangles, positions_b, contacts,
                               UINT32_MAX);
  return contacts;
}

}  // namespace pelt::test
