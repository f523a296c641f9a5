#include "solids.hpp"
#include "support/instruction_sets.hpp"
#include "support/values.hpp"

#include <pelt/asset.hpp>
#include <pelt/bounds.hpp>

#include <filesystem>

namespace pelt {
namespace {

using detail::point_at;
using detail::Vec3d;
using test::distance_to;
using test::Random;
using test::random_solid;
using test::Shape;

/// The distance of a triangle is that of its closest point.
TEST(SolidDistance, OfATriangleIsThatOfItsClosestPoint) {
  Random random(740);
  int apart = 0;
  for (int round = 0; round < 3000; ++round) {
    const Solid solid = random_solid(random, {}, 1);
    const detail::TriangleCorners t = {random.point(2), random.point(2), random.point(2)};
    if (test::touches(solid, t)) {
      const Vec3d common = point_at(t, detail::common_point(t, solid));
      EXPECT_LE(distance_to(solid, common), 1e-6);
      continue;
    }
    ++apart;
    const detail::SolidPoints points = detail::closest_points(t, solid);
    EXPECT_NEAR(distance_to(solid, point_at(t, points.at)), points.distance, 1e-6);
    EXPECT_NEAR(distance_to(solid, points.on_solid), 0, 1e-6);
    for (int i = 0; i < 60; ++i) {
      const double u = random.unit(), v = random.unit() * (1 - u);
      EXPECT_GE(distance_to(solid, point_at(t, {1 - u - v, u, v})), points.distance - 1e-6);
    }
  }
  EXPECT_GT(apart, 500);
  EXPECT_LT(apart, 2500);
}

/// Queries of one pose, and the answers of brute force.
struct Asked {
  Asked(std::span<const Triangle> t, Pose& p)
      : triangles(t), pose(p), positions(p.model().vertex_count()) {
    posed_vertices(pose, positions);
  }

  double expect_as_brute_force(const Solid& solid) {
    const test::BruteSolidDistance expected = test::brute_distance(solid, triangles, positions);
    SolidDistance closest;
    distance(pose, solid, scratch, closest);
    EXPECT_EQ(closest.distance, expected.distance);
    EXPECT_EQ(closest.surface.triangle, expected.triangle);
    const double size = std::abs(double{closest.surface.position.x}) +
                        std::abs(double{closest.surface.position.y}) +
                        std::abs(double{closest.surface.position.z}) + expected.distance;
    const Vec3d way = Vec3d(closest.surface.position) - Vec3d(closest.solid);
    EXPECT_NEAR(std::sqrt(squared_length(way)), expected.distance, 1e-6 * size);

    SolidDistance within;
    distance(pose, solid, scratch, within, {.max_distance = expected.distance});
    EXPECT_EQ(within.distance, expected.distance);
    if (expected.distance > 0) {
      distance(pose, solid, scratch, within, {.max_distance = 0.99 * expected.distance});
      EXPECT_FALSE(within);
    }
    return expected.distance;
  }

  std::span<const Triangle> triangles;
  Pose& pose;
  std::vector<Vec3> positions;
  Scratch scratch;
};

TEST(SolidDistance, EqualsBruteForceOnBendingLimbsOnEachTarget) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(741);
    const Shape limb = test::make_limb(20, 8, 4);
    Pose pose(*build_model(limb.view()));
    int touching = 0, apart = 0;
    for (int round = 0; round < 30; ++round) {
      const Vec3 place = random.point(round % 4 ? 1 : 1e3);
      ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 4, 0.5, place)));
      Asked asked(limb.triangles, pose);
      for (int i = 0; i < 10; ++i)
        ++(asked.expect_as_brute_force(random_solid(random, place, 2)) > 0 ? apart : touching);
    }
    EXPECT_GT(touching, 30);
    EXPECT_GT(apart, 150);
  });
}

/// The ground below it, a ball around it, a wall far away.
TEST(SolidDistance, WhatIsInsideTouchesWithoutBeingOpened) {
  const Shape limb = test::make_limb(20, 8, 4);
  Pose pose(*build_model(limb.view()));
  Asked asked(limb.triangles, pose);
  EXPECT_EQ(asked.expect_as_brute_force(Sphere{{}, 100}), 0);
  EXPECT_EQ(asked.expect_as_brute_force(Box{{-9, -9, -9}, {9, 9, 9}}), 0);
  EXPECT_EQ(asked.expect_as_brute_force(HalfSpace{{0, 2, 0}, -4}), 2);
  EXPECT_GT(asked.expect_as_brute_force(Sphere{{1e6f, 0, 0}, 1}), 9e5);
}

/// The square of the distance overflows a float.
TEST(SolidDistance, OfASolidThatIsVeryFarIsFound) {
  const Shape limb = test::make_limb(20, 8, 4);
  Pose pose(*build_model(limb.view()));
  Asked asked(limb.triangles, pose);
  EXPECT_EQ(asked.expect_as_brute_force(HalfSpace{{0, 0x1p-75f, 0}, -2}), 0x1p76);
  EXPECT_EQ(asked.expect_as_brute_force(HalfSpace{{0, 0x1p-100f, 0}, -0x1p20f}), 0x1p120);
  EXPECT_EQ(asked.expect_as_brute_force(Box{{0x1p127f, 0, 0}, {0x1p127f, 1, 1}}), 0x1p127);
  EXPECT_EQ(asked.expect_as_brute_force(Sphere{{0, 0, -0x1p126f}, 1}), 0x1p126);
}

class SharedSolids : public testing::TestWithParam<const char*> {};

TEST_P(SharedSolids, EqualBruteForce) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Pose pose(*build_model(asset->mesh(), {.off_weights = OffWeights::renormalise}));
  Random random(744);
  asset::SampleScratch sampling;
  std::vector<Matrix4> palette(pose.model().joint_count());
  int apart = 0;
  for (int round = 0; round < 3; ++round) {
    const asset::Clip& clip = asset->clips.front();
    sample_palette(*asset, &clip, clip.duration * random.uniformf(0, 1), {}, sampling, palette);
    ASSERT_TRUE(pose.set_palette(palette));
    Asked asked(asset->triangles, pose);
    const Sphere around = test::bounds_of(pose).sphere;
    for (int i = 0; i < 5; ++i)
      apart += asked.expect_as_brute_force(
                   random_solid(random, around.centre, 2 * double{around.radius})) > 0;
  }
  EXPECT_GT(apart, 3);
}

INSTANTIATE_TEST_SUITE_P(Models, SharedSolids,
                         testing::Values("human.glb", "knight.glb", "fox_khronos.glb"));

}  // namespace
}  // namespace pelt
