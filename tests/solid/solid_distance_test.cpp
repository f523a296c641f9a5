#include <pelt/bounds.hpp>

#include "solid/solids.hpp"
#include "support/animated_character.hpp"
#include "support/instruction_sets.hpp"
#include "support/values.hpp"

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

using SharedSolids = test::OfSharedModels<>;

TEST_P(SharedSolids, EqualBruteForce) {
  Random random(744);
  int apart = 0;
  for (int round = 0; round < 3; ++round) {
    const asset::Clip& clip = character->asset.clips.front();
    character->move(&clip, clip.duration * random.uniformf(0, 1));
    Asked asked(character->asset.triangles, character->pose);
    const Sphere around = test::bounds_of(character->pose).sphere;
    for (int i = 0; i < 5; ++i)
      apart += asked.expect_as_brute_force(
                   random_solid(random, around.centre, 2 * double{around.radius})) > 0;
  }
  EXPECT_GT(apart, 3);
}

INSTANTIATE_TEST_SUITE_P(Models, SharedSolids,
                         testing::Values("human.glb", "knight.glb", "fox_khronos.glb"));

Vec3d place_at(const Ray& ray, double t) { return Vec3d(ray.origin) + t * Vec3d(ray.direction); }

/// Checks that the hit is on the surface, and that the ray before it (or, without a hit, all of it)
/// is outside.
void expect_first_point(const Solid& solid, const Ray& ray, const SolidHit& hit, Random& random) {
  const double end = hit ? double{hit.t} : double{ray.t_max};
  if (hit) {
    EXPECT_NEAR(distance_to(solid, place_at(ray, end)), 0, 1e-5);
    EXPECT_LT(dot(Vec3d(hit.normal), Vec3d(ray.direction)), 1e-3);
    EXPECT_NEAR(squared_length(Vec3d(hit.normal)), 1, 1e-6);
  }
  for (int i = 0; i < 40; ++i) {
    const double t = double{ray.t_min} + 0.95 * random.unit() * (end - double{ray.t_min});
    EXPECT_GT(distance_to(solid, place_at(ray, t)), 0) << t << " of " << end;
  }
}

TEST(SolidCast, FindsTheFirstPointInside) {
  Random random(760);
  int hits = 0, misses = 0, begins_inside = 0;
  for (int round = 0; round < 4000; ++round) {
    const Solid solid = test::random_solid(random, {}, 1);
    Ray ray = segment(random.point(2), random.point(2));
    ray.t_min = random.uniformf(-0.5, 0.5);
    ray.t_max = random.uniformf(0.5, 2);
    const SolidHit hit = test::first_hit(solid, ray);
    if (hit && hit.t == ray.t_min && hit.normal == Vec3()) {
      EXPECT_LE(distance_to(solid, place_at(ray, double{ray.t_min})), 1e-9);
      ++begins_inside;
      continue;
    }
    expect_first_point(solid, ray, hit, random);
    ++(hit ? hits : misses);
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(misses, 1000);
  EXPECT_GT(begins_inside, 300);
}

TEST(SolidCast, GivesPlacesAndNormals) {
  const Ray down = {{0.25f, 9, 0}, {0, -2, 0}};
  EXPECT_EQ(test::first_hit(HalfSpace{{0, 3, 0}, 3}, down).t, 4);
  EXPECT_EQ(test::first_hit(HalfSpace{{0, 3, 0}, 3}, down).normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(test::first_hit(Box{{0, 0, 0}, {1, 1, 1}}, down).t, 4);
  EXPECT_EQ(test::first_hit(
                OrientedBox{{0, 0, 0}, {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, 1}}, down)
                .t,
            4);
  EXPECT_EQ(test::first_hit(Sphere{{0.25f, 0, 0}, 1}, down).t, 4);
  EXPECT_EQ(test::first_hit(Capsule{{-9, 0, 0}, {9, 0, 0}, 1}, down).t, 4);
  EXPECT_EQ(test::first_hit(Capsule{{-9, 0, 0}, {9, 0, 0}, 1}, down).normal, (Vec3{0, 1, 0}));
  EXPECT_FALSE(test::first_hit(Sphere{{2, 0, 0}, 1}, down));
  EXPECT_FALSE(test::first_hit(Box{{0.5f, 0, 0}, {1, 1, 1}}, down));
  EXPECT_FALSE(test::first_hit(Sphere{{0.25f, 10, 0}, 0.5f}, down));  // behind it
}

/// A normal of zero would mean that the ray begins inside.
TEST(SolidCast, GivesNormalsOfPointsAndSegments) {
  const Ray down = {{0.25f, 9, 0}, {0, -2, 0}}, along = {{-5, 0, 0}, {3, 0, 0}};
  const Capsule segment{{-1, 0, 0}, {1, 0, 0}, 0}, point{{0.25f, 1, 0}, {0.25f, 1, 0}, 0};
  EXPECT_EQ(test::first_hit(Sphere{{0.25f, 1, 0}, 0}, down).t, 4);
  EXPECT_EQ(test::first_hit(Sphere{{0.25f, 1, 0}, 0}, down).normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(test::first_hit(point, down).normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(test::first_hit(segment, down).t, 4.5f);
  EXPECT_EQ(test::first_hit(segment, down).normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(test::first_hit(segment, {{-1.75f, 2, 0}, {1, -1, 0}}).normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(test::first_hit(segment, along).normal, (Vec3{-1, 0, 0}));
  EXPECT_EQ(test::first_hit(segment, {{0, 0, 0}, {3, 0, 0}}).normal, Vec3());
}

/// Far away, t as a float is off by more than the radius of the ball.
TEST(SolidCast, GivesNormalsFarAway) {
  const Ray ray = {{1 << 20, 0, 0}, {-1, 0, 0}};
  const SolidHit ball = test::first_hit(Sphere{{0.33f, 0, 0}, 0x1p-8f}, ray);
  EXPECT_EQ(ball.normal, (Vec3{1, 0, 0}));
  const Capsule pin{{0.33f, -1, 0}, {0.33f, 1, 0}, 0x1p-8f};
  EXPECT_EQ(test::first_hit(pin, ray).normal, (Vec3{1, 0, 0}));
}

/// By rounding, some rays along the side enter through the flat end of its cylinder.
TEST(SolidCast, GivesTheNormalOfTheSideAtTheRimOfACapsule) {
  int hits = 0;
  for (int length = 1; length <= 10; ++length)
    for (int start = 1; start <= 10; ++start) {
      const Capsule pin{{0, 0, 0}, {0, 0, 0.7f * static_cast<float>(length)}, 1};
      const SolidHit hit =
          test::first_hit(pin, {{1, 0, -0.9f * static_cast<float>(start)}, {0, 0, 1}});
      ASSERT_TRUE(hit) << length << ", " << start;
      EXPECT_EQ(hit.normal.x, 1) << length << ", " << start;
      EXPECT_NEAR(hit.normal.z, 0, 1e-15) << length << ", " << start;
      ++hits;
    }
  EXPECT_EQ(hits, 100);
}

TEST(SolidCast, MissesBeyondTheLongestFloat) {
  const SolidHit hit = test::first_hit(Sphere{{0, 0, 0}, 1}, {{1e30f, 0, 0}, {-1e-10f, 0, 0}});
  EXPECT_FALSE(hit);
  EXPECT_EQ(hit.normal, Vec3());
}

/// From a million units away, a ball of one unit is still hit at the right position.
TEST(SolidCast, IsRightFromFarAway) {
  const SolidHit hit = test::first_hit(Sphere{{0, 0, 0}, 1}, {{1 << 20, 0, 0}, {-1, 0, 0}});
  EXPECT_EQ(hit.t, (1 << 20) - 1);
  EXPECT_FALSE(test::first_hit(Sphere{{0, 1.0001f, 0}, 1}, {{1 << 20, 0, 0}, {-1, 0, 0}}));
}

}  // namespace
}  // namespace pelt
