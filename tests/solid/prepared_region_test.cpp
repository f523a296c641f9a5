/// Each kind of region matches its documentation.

#include <pelt/math.hpp>
#include <pelt/solid.hpp>

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

/// Column-major. `depth` selects glTF's perspective camera for OpenGL or for Vulkan.
Matrix4 perspective(float near, float far, ClipDepth depth) {
  Matrix4 m;
  m.m = {};
  m.m[0] = 1.3f, m.m[5] = 1.7f, m.m[11] = -1;
  if (depth == ClipDepth::minus_one_to_one) {
    m.m[10] = (far + near) / (near - far);
    m.m[14] = 2 * far * near / (near - far);
  } else {
    m.m[10] = far / (near - far);
    m.m[14] = far * near / (near - far);
  }
  return m;
}

bool is_in(const Frustum& frustum, const Vec3& p) {
  for (const HalfSpace& face : frustum.faces)
    if (face.normal.x * p.x + face.normal.y * p.y + face.normal.z * p.z > face.offset) return false;
  return true;
}

TEST(Frustum, HasThePointsThatAreDrawn) {
  Random random(550);
  int seen = 0;
  for (const ClipDepth depth : {ClipDepth::minus_one_to_one, ClipDepth::zero_to_one}) {
    const Frustum frustum = make_frustum(perspective(0.5f, 20, depth), depth);
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p = {random.uniformf(-10, 10), random.uniformf(-10, 10), random.uniformf(-22, 2)};
      const double away = -static_cast<double>(p.z);
      const double margin = std::min({away - 0.5, 20 - away, away - 1.3 * std::fabs(double{p.x}),
                                      away - 1.7 * std::fabs(double{p.y})});
      if (std::fabs(margin) < 1e-4) continue;
      EXPECT_EQ(is_in(frustum, p), margin > 0) << p.x << ' ' << p.y << ' ' << p.z;
      seen += margin > 0;
    }
  }
  EXPECT_GT(seen, 500);
}

TEST(Frustum, WithoutAFarPlaneLeavesNothingFarOut) {
  Matrix4 m = perspective(0.5f, 20, ClipDepth::minus_one_to_one);
  m.m[10] = -1, m.m[14] = -1;
  const Frustum frustum = make_frustum(m);
  EXPECT_TRUE(is_in(frustum, {0, 0, -1e30f}));
  EXPECT_FALSE(is_in(frustum, {0, 0, -0.4f}));
}

TEST(Frustum, IsAConvexPolyhedronOfSixFaces) {
  const Frustum frustum = make_frustum(Matrix4{});
  const ConvexPolyhedron polyhedron = frustum;
  EXPECT_EQ(polyhedron.faces().size(), 6u);
  EXPECT_TRUE(is_in(frustum, {1, -1, 1}));
  EXPECT_FALSE(is_in(frustum, {1.5f, 0, 0}));
}

TEST(Frustum, ARegionOfATemporaryOwnsItsFaces) {
  const Region region = make_frustum(Matrix4{});
  const auto& polyhedron = std::get<ConvexPolyhedron>(region);
  const Frustum frustum = make_frustum(Matrix4{});
  ASSERT_EQ(polyhedron.faces().size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(polyhedron.faces()[i].normal, frustum.faces[i].normal);
    EXPECT_EQ(polyhedron.faces()[i].offset, frustum.faces[i].offset);
  }
  const auto* begin = reinterpret_cast<const char*>(&region);
  const auto* faces = reinterpret_cast<const char*>(polyhedron.faces().data());
  EXPECT_TRUE(begin <= faces && faces < begin + sizeof region);
}

}  // namespace
}  // namespace pelt
