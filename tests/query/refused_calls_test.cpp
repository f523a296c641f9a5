/// Violated preconditions abort with a message in every build.

#include <pelt/pelt.hpp>

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

class RefusedCalls : public testing::Test {
 protected:
  Pose a{*build_model(test::make_limb(12, 8, 3).view())};
  Pose b{*build_model(test::make_limb(12, 9, 3).view())};
  Surface of_a{a.model()}, of_b{b.model()};
  Scratch scratch;
};

TEST_F(RefusedCalls, OnePoseTwice) {
  const char* message = "are the same pose";
  std::vector<Contact> contacts;
  std::vector<NearPair> pairs;
  Distance closest;
  Penetration deepest;
  Containment containing = Containment::none;
  ContactGeometry geometry;
  EXPECT_DEATH(collide(a, a, scratch, contacts), message);
  EXPECT_DEATH(intersects(a, a, scratch), message);
  EXPECT_DEATH(distance(a, a, scratch, closest), message);
  EXPECT_DEATH(clearance(a, a, 1, scratch, pairs), message);
  EXPECT_DEATH(is_within(a, a, 1, scratch), message);
  EXPECT_DEATH(deepest_vertex(a, of_a, a, of_a, scratch, deepest), message);
  EXPECT_DEATH(containment(a, of_a, a, of_a, scratch, containing), message);
  EXPECT_DEATH(describe_contacts(a, of_a, a, of_a, {}, scratch, geometry), message);
}

TEST_F(RefusedCalls, ASurfaceOfAnotherModel) {
  const char* message = "to another model";
  ContactGeometry geometry;
  PointSide side = PointSide::outside;
  Containment containing = Containment::none;
  EXPECT_DEATH(describe_contacts(a, of_b, b, of_b, {}, scratch, geometry), message);
  EXPECT_DEATH(describe_contacts(a, of_b, {}, scratch, geometry), message);
  EXPECT_DEATH(side_of(a, of_b, {}, scratch, side), message);
  EXPECT_DEATH(containment(a, of_a, b, of_a, scratch, containing), message);
}

TEST_F(RefusedCalls, DistancesAndListsThatMakeNoSense) {
  ClosestPoint closest;
  EXPECT_DEATH(closest_point(a, {}, scratch, closest, {-1}), "negative or NaN");
  EXPECT_DEATH(is_within(a, b, -1, scratch), "negative or NaN");
  RayHit hit;
  EXPECT_DEATH(cast(a, {}, {&hit, 1}), "one hit for each ray");
  const std::vector<HalfSpace> faces(ConvexPolyhedron::kMaxFaces + 1);
  EXPECT_DEATH(ConvexPolyhedron{faces}, "more than 64 faces");
}

}  // namespace
}  // namespace pelt
