#include "solids.hpp"
#include "support/values.hpp"

namespace pelt {
namespace {

using detail::Vec3d;
using test::distance_to;
using test::Random;

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
