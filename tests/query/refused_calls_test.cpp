/// Violated preconditions abort with a message in every build.

#include <pelt/pelt.hpp>

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace pelt {
namespace {

class RefusedCalls : public testing::Test {
 protected:
  Pose a{*build_model(test::make_limb(12, 8, 3).view())};
  Pose b{*build_model(test::make_limb(12, 9, 3).view())};
  Scratch scratch;
};

TEST_F(RefusedCalls, OnePoseTwice) {
  const char* message = "are the same pose";
  std::vector<Contact> contacts;
  std::vector<Contact> pairs;
  Distance closest;
  Penetration deepest;
  Containment containing = Containment::none;
  ContactGeometry geometry;
  EXPECT_DEATH(collide(a, a, scratch, contacts), message);
  EXPECT_DEATH(intersects(a, a, scratch), message);
  EXPECT_DEATH(distance(a, a, scratch, closest), message);
  EXPECT_DEATH(clearance(a, a, 1, scratch, pairs), message);
  EXPECT_DEATH(is_within(a, a, 1, scratch), message);
  EXPECT_DEATH(deepest_vertex(a, a, scratch, deepest), message);
  EXPECT_DEATH(containment(a, a, scratch, containing), message);
  EXPECT_DEATH(describe_contacts(a, a, {}, scratch, geometry), message);
  Volume common;
  EXPECT_DEATH(intersection_volume(a, a, scratch, common), message);
}

TEST_F(RefusedCalls, DistancesAndListsThatMakeNoSense) {
  ClosestPoint closest;
  EXPECT_DEATH(closest_point(a, {}, scratch, closest, {.max_distance = -1}), "negative or NaN");
  EXPECT_DEATH(is_within(a, b, -1, scratch), "negative or NaN");
  RayHit hit;
  EXPECT_DEATH(cast(a, {}, {&hit, 1}), "one hit for each ray");
  const std::vector<HalfSpace> faces(ConvexPolyhedron::kMaxFaces + 1);
  EXPECT_DEATH(ConvexPolyhedron{faces}, "more than 64 faces");
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST_F(RefusedCalls, PointsAndDirectionsThatAreNotFinite) {
  ClosestPoint closest;
  PointSide side = PointSide::outside;
  std::int32_t winding = 0;
  FarthestVertex farthest;
  for (const Vec3& point : {Vec3{kNan, 0, 0}, Vec3{0, kInfinity, 0}, Vec3{0, 0, -kInfinity}}) {
    EXPECT_DEATH(closest_point(a, point, scratch, closest), "the point is NaN or infinite");
    EXPECT_DEATH(side_of(a, point, scratch, side), "the point is NaN or infinite");
    EXPECT_DEATH(winding_number(a, point, scratch, winding), "the point is NaN or infinite");
    EXPECT_DEATH(farthest_vertex(a, point, farthest), "the direction is zero, NaN or infinite");
  }
  const Vec3 nowhere = {0, 0, kNan};
  EXPECT_DEATH(closest_points(a, {&nowhere, 1}, scratch, {&closest, 1}), "the point is NaN");
  EXPECT_DEATH(farthest_vertex(a, {}, farthest), "the direction is zero");
}

TEST_F(RefusedCalls, RaysThatAreNotNumbers) {
  const char* message = "has a NaN or infinite coordinate";
  const std::vector<float> heights(4);
  const HeightField field =
      *build_height_field({.heights = heights, .columns = 2, .rows = 2, .origin = {}});
  RayHit hit;
  SolidHit solid_hit;
  bool any = false;
  std::vector<RayHit> hits;
  for (const Ray& ray : {Ray{{kNan, 0, 0}, {1, 0, 0}}, Ray{{}, {0, kInfinity, 0}},
                         Ray{{}, {1, 0, 0}, kNan}, Ray{{}, {1, 0, 0}, 0, kNan}}) {
    EXPECT_DEATH(cast(a, ray, hit), message);
    EXPECT_DEATH(cast_any(a, {&ray, 1}, {&any, 1}), message);
    EXPECT_DEATH(cast_all(a, ray, scratch, hits), message);
    EXPECT_DEATH(cast(field, ray, hit), message);
    EXPECT_DEATH(cast(Sphere{{}, 1}, ray, solid_hit), message);
  }
  EXPECT_DEATH(cast(Sphere{{}, 1}, Ray{{}, {1, 0, 0}, -kInfinity}, solid_hit), "or start");
}

TEST_F(RefusedCalls, RegionsThatAreNotNumbers) {
  Placement placement = Placement::outside;
  const auto refuses = [&](const Region& region, const char* message) {
    EXPECT_DEATH(classify(a, region, scratch, placement), message);
  };
  refuses(HalfSpace{{kNan, 0, 1}, 0}, "a number of the region is NaN or infinite");
  refuses(HalfSpace{{1, 0, 0}, kInfinity}, "a number of the region is NaN or infinite");
  refuses(Box{{0, 0, 0}, {1, 1, kNan}}, "a number of the region is NaN or infinite");
  refuses(OrientedBox{.centre = {0, kNan, 0}, .half = {}},
          "a number of the region is NaN or infinite");
  refuses(OrientedBox{.centre = {}, .half = {1, -1, 1}}, "a half extent of the region is negative");
  refuses(Sphere{{}, -1}, "the radius of the region is negative");
  refuses(Sphere{{}, kNan}, "the radius of the region is negative, NaN or infinite");
  refuses(Capsule{{}, {0, kInfinity, 0}, 1}, "a point of the region is NaN or infinite");
}

TEST_F(RefusedCalls, SolidsWithoutADistance) {
  SolidDistance closest;
  SolidHit hit;
  const auto refuses = [&](const Solid& solid, const char* message) {
    EXPECT_DEATH(distance(a, solid, scratch, closest), message);
    EXPECT_DEATH(cast(solid, Ray{{}, {1, 0, 0}}, hit), message);
  };
  refuses(HalfSpace{{}, 1}, "the normal of the half-space is zero");
  refuses(Box{{0, 1, 0}, {1, 0, 1}}, "the low corner of the box is above its high corner");
  refuses(Sphere{{}, -1}, "the radius of the region is negative");
}

}  // namespace
}  // namespace pelt
