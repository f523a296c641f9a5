/// Each kind of region matches its documentation.

#include "solid/region_oracle.hpp"
#include "support/random.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pelt {
namespace {

using test::Random;

double dot(const Vec3& a, const Vec3& b) {
  return double{a.x} * double{b.x} + double{a.y} * double{b.y} + double{a.z} * double{b.z};
}

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

double distance(const Vec3& a, const Vec3& b) { return std::sqrt(dot(minus(a, b), minus(a, b))); }

/// The depth of a point inside; negative outside.
double depth(const HalfSpace& half, const Vec3& p) {
  return double{half.offset} - dot(half.normal, p);
}

double depth(const Box& box, const Vec3& p) {
  return std::min({double{p.x} - double{box.low.x}, double{box.high.x} - double{p.x},
                   double{p.y} - double{box.low.y}, double{box.high.y} - double{p.y},
                   double{p.z} - double{box.low.z}, double{box.high.z} - double{p.z}});
}

double depth(const OrientedBox& box, const Vec3& p) {
  const Vec3 away = minus(p, box.centre);
  return std::min({double{box.half.x} - std::fabs(dot(box.axes[0], away)),
                   double{box.half.y} - std::fabs(dot(box.axes[1], away)),
                   double{box.half.z} - std::fabs(dot(box.axes[2], away))});
}

double depth(const ConvexPolyhedron& polyhedron, const Vec3& p) {
  double least = HUGE_VAL;
  for (const HalfSpace& face : polyhedron.faces()) least = std::min(least, depth(face, p));
  return least;
}

double depth(const Sphere& sphere, const Vec3& p) {
  return double{sphere.radius} - distance(sphere.centre, p);
}

double depth(const Capsule& capsule, const Vec3& p) {
  double closest = HUGE_VAL;
  for (int i = 0; i <= 1000; ++i) {
    const float t = static_cast<float>(i) / 1000;
    const Vec3 q = {capsule.a.x + t * (capsule.b.x - capsule.a.x),
                    capsule.a.y + t * (capsule.b.y - capsule.a.y),
                    capsule.a.z + t * (capsule.b.z - capsule.a.z)};
    closest = std::min(closest, distance(p, q));
  }
  return double{capsule.radius} - closest;
}

TEST(PreparedRegion, HasThePointsThatTheShapesHave) {
  Random random(570);
  const std::array<HalfSpace, 3> faces = {HalfSpace{{1, 2, 0}, 1}, HalfSpace{{-1, 0, 1}, 0.5f},
                                          HalfSpace{{0, -1, -1}, 0.7f}};
  const Matrix4 turn = test::rotation_about({1, 2, 3}, 1, {}, {});
  const auto axis = [&](std::size_t i) {
    return Vec3{turn.m[4 * i], turn.m[4 * i + 1], turn.m[4 * i + 2]};
  };
  const Region regions[] = {
      faces[0],
      Box{{-0.5f, -0.2f, 0}, {0.3f, 0.8f, 0.9f}},
      OrientedBox{{0.1f, 0.2f, 0.3f}, {axis(0), axis(1), axis(2)}, {0.9f, 0.5f, 0.7f}},
      ConvexPolyhedron{faces},
      Sphere{{0.2f, 0.1f, -0.3f}, 0.8f},
      Capsule{{-0.6f, 0, 0.2f}, {0.5f, 0.4f, 0}, 0.4f}};
  for (const Region& region : regions) {
    const detail::PreparedRegion prepared(region);
    int inside = 0, outside = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = random.point(1.2);
      const double deep = std::visit([&](const auto& shape) { return depth(shape, p); }, region);
      if (std::fabs(deep) < 1e-4) continue;
      EXPECT_EQ(test::place_of(prepared, {p, p, p}) == detail::TrianglePlace::inside, deep > 0);
      ++(deep > 0 ? inside : outside);
    }
    EXPECT_GT(inside, 100) << "region " << region.index();
    EXPECT_GT(outside, 150) << "region " << region.index();
  }
}

}  // namespace
}  // namespace pelt
