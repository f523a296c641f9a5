#pragma once

/// Characters at both ends of a step.

#include "collide/moving_brute_force.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace pelt::test {

using Step = pelt::Motion;

/// A character at both ends of a step.
struct Body {
  explicit Body(Shape s, const ModelOptions& how = {})
      : shape(std::move(s)), from(*build_model(shape.view(), how)), to(from.model()) {}

  Step step() { return {from, to}; }

  void move(const std::vector<Matrix4>& first, const std::vector<Matrix4>& last) {
    ASSERT_TRUE(from.set_palette(first));
    ASSERT_TRUE(to.set_palette(last));
  }

  MovingTriangles triangles() const { return moving_triangles(shape.triangles, from, to); }

  Shape shape;
  Pose from, to;
};

inline std::vector<MovingContact> contacts_of(Body& a, Body& b, const MovingOptions& options = {}) {
  Scratch scratch;
  std::vector<MovingContact> contacts;
  collide(a.step(), b.step(), scratch, contacts, options);
  return contacts;
}

inline std::vector<MovingContact> brute_force(const Body& a, const Body& b) {
  return brute_force_moving(a.triangles(), b.triangles());
}

/// Two bending limbs, of which one moves past the other or into it.
struct Limbs {
  Body a = Body(make_limb(14, 8, 4)), b = Body(make_limb(12, 7, 3));

  void move(Random& random, double distance) {
    const auto bend = [&](std::uint32_t joints) {
      const double angle = random.uniform(-0.4, 0.4);
      return bend_limb(random, joints, angle, random.point(distance));
    };
    const auto from_a = bend(4), to_a = bend(4), from_b = bend(3), to_b = bend(3);
    a.move(from_a, to_a);
    b.move(from_b, to_b);
  }
};

}  // namespace pelt::test
