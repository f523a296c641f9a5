#pragma once

/// Characters at both ends of a step, and the test of all pairs of their triangles. It uses the
/// filtered test, which tests/motion compares with the exact one.

#include <pelt/motion.hpp>

#include "motion/moving_filter.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

  std::vector<detail::MovingTriangle> triangles() const {
    std::vector<Vec3> first(shape.rest_positions.size()), last(first.size());
    posed_vertices(from, first);
    posed_vertices(to, last);
    std::vector<detail::MovingTriangle> all;
    for (const Triangle& t : shape.triangles)
      all.push_back(
          {{first[t[0]], first[t[1]], first[t[2]]}, {last[t[0]], last[t[1]], last[t[2]]}});
    return all;
  }

  Shape shape;
  Pose from, to;
};

inline std::vector<MovingContact> contacts_of(Body& a, Body& b, const MovingOptions& options = {}) {
  Scratch scratch;
  std::vector<MovingContact> contacts;
  collide(a.step(), b.step(), scratch, contacts, options);
  return contacts;
}

inline Feature feature(const detail::ClosedFeature& f) {
  return {static_cast<FeatureKind>(f.kind), f.number};
}

/// Whether the boxes of the whole paths of two triangles are disjoint.
inline bool are_far(const detail::MovingTriangle& a, const detail::MovingTriangle& b) {
  for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const auto range = [&](const detail::MovingTriangle& t) {
      return std::minmax({t.from[0].*axis, t.from[1].*axis, t.from[2].*axis, t.to[0].*axis,
                          t.to[1].*axis, t.to[2].*axis});
    };
    if (range(a).second < range(b).first || range(b).second < range(a).first) return true;
  }
  return false;
}

inline std::vector<MovingContact> brute_force_moving(const std::vector<detail::MovingTriangle>& a,
                                                     const std::vector<detail::MovingTriangle>& b) {
  MovingStats work;
  std::vector<MovingContact> contacts;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t k = 0; k < b.size(); ++k) {
      if (are_far(a[i], b[k])) continue;
      if (const auto first = detail::find_first_meeting(a[i], b[k], work)) {
        MovingContact contact{{i, k}, first->time, first->at_start, {}, {}};
        if (!first->at_start) contact.a = feature(first->a), contact.b = feature(first->b);
        contacts.push_back(contact);
      }
    }
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
