#pragma once

#include <pelt/inside.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pelt::test {

/// The integral of w (w - 1) / 2, from the intersection of a body with a copy, where w is counted
/// twice, and from its volume.
inline Volume volume_with_a_copy(Pose& pose) {
  std::vector<Vec3> posed(pose.model().vertex_count());
  posed_vertices(pose, posed);
  Pose copy(pose.model());
  EXPECT_TRUE(copy.set_vertices(posed));
  Scratch scratch;
  Volume product, whole;
  intersection_volume(pose, copy, scratch, product);
  volume(pose, whole);
  return {(product.value - whole.value) / 2, (product.error + whole.error) / 2};
}

inline void expect_equal_within_errors(const Volume& a, const Volume& b) {
  EXPECT_LE(std::abs(a.value - b.value), a.error + b.error) << a.value << " and " << b.value;
}

}  // namespace pelt::test
