#pragma once

/// The contacts of two poses, by a query and by brute force.

#include "support/brute_force.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/collide.hpp>

#include <vector>

namespace pelt::test {

inline std::vector<Contact> contacts_of(Pose& a, Pose& b, Scratch& scratch) {
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  return contacts;
}

inline std::vector<Contact> brute_force(const Shape& a, const Pose& pose_a, const Shape& b,
                                        const Pose& pose_b) {
  return brute_force(a.triangles, pose_a, b.triangles, pose_b);
}

}  // namespace pelt::test
