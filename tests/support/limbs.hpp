#pragma once

#include "support/brute_force.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::test {

/// Two bending limbs, some of which touch.
struct LimbPair {
  Shape shape_a = make_limb(24, 10, 5), shape_b = make_limb(17, 9, 4);
  Pose a = Pose(*build_model(shape_a.view())), b = Pose(*build_model(shape_b.view()));
  Scratch scratch;

  void move(Random& random, double distance) {
    ASSERT_TRUE(a.set_palette(bend_limb(random, 5, random.uniform(-0.6, 0.6), {})));
    ASSERT_TRUE(
        b.set_palette(bend_limb(random, 4, random.uniform(-0.6, 0.6), random.point(distance))));
  }

  std::vector<detail::TriangleCorners> triangles_a() const {
    return posed_triangles(shape_a.triangles, a);
  }
  std::vector<detail::TriangleCorners> triangles_b() const {
    return posed_triangles(shape_b.triangles, b);
  }
};

}  // namespace pelt::test
