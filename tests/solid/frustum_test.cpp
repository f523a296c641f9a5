#include <pelt/math.hpp>
#include <pelt/solid.hpp>

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt {
namespace {

using test::Random;

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
