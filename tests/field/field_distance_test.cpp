#include "distance/brute_distance.hpp"
#include "fields.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

namespace pelt {
namespace {

using test::make_hills;
using test::make_plain;
using test::Random;
using test::Shape;

/// The existing triangles of a field, and their numbers.
struct Existing {
  explicit Existing(const HeightField& field) {
    for (std::uint32_t t = 0; t < field.triangle_count(); ++t) {
      if (test::is_hole(field.triangle(t))) continue;
      triangles.push_back(field.triangle(t));
      numbers.push_back(t);
    }
  }

  std::vector<test::TriangleCorners> triangles;
  std::vector<std::uint32_t> numbers;
};

/// Queries of one pose, and the answers of brute force.
struct Asked {
  double expect_as_brute_force(const HeightField& field) {
    const Existing existing(field);
    const test::BruteDistance expected =
        test::brute_distance(test::posed_triangles(shape.triangles, pose), existing.triangles);
    const Distance last = closest;
    for (const Distance* hint : {static_cast<const Distance*>(nullptr), &last}) {
      distance(pose, field, scratch, closest, {.hint = hint});
      EXPECT_EQ(closest.distance, expected.distance);
      EXPECT_EQ(closest.lower_bound, expected.distance);
      EXPECT_EQ(closest.a.triangle, expected.triangle_a);
      EXPECT_EQ(closest.b.triangle, existing.numbers[expected.triangle_b]);
      expect_points_apart(expected.distance);
    }
    expect_limits_hold(field, expected.distance);
    return expected.distance;
  }

  void expect_points_apart(double expected) const {
    const detail::Vec3d way = detail::Vec3d(closest.a.position) - detail::Vec3d(closest.b.position);
    const double size = std::abs(double{closest.a.position.x}) +
                        std::abs(double{closest.a.position.y}) +
                        std::abs(double{closest.a.position.z});
    EXPECT_NEAR(std::sqrt(squared_length(way)), expected, 1e-6 * (1 + size));
  }

  void expect_limits_hold(const HeightField& field, double expected) {
    Distance found;
    distance(pose, field, scratch, found, {.max_distance = expected});
    EXPECT_EQ(found.distance, expected);
    if (expected > 0) {
      distance(pose, field, scratch, found, {.max_distance = 0.99 * expected});
      EXPECT_FALSE(found);
      EXPECT_EQ(found.lower_bound, 0.99 * expected);
    }
    distance(pose, field, scratch, found, {.tolerance = 0.1});
    EXPECT_GE(found.distance, expected);
    EXPECT_LE(found.distance, expected + 0.1);
    EXPECT_LE(found.lower_bound, expected);
  }

  const Shape& shape;
  Pose& pose;
  Scratch scratch = {};
  Distance closest = {};
};

TEST(FieldDistance, EqualsBruteForceOnBendingLimbsOnEachTarget) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(720);
    const Shape limb = test::make_limb(10, 6, 3);
    Pose pose(*build_model(limb.view()));
    Asked asked{limb, pose};
    int touching = 0, apart = 0;
    for (int round = 0; round < 40; ++round) {
      const float spacing = random.uniformf(0.05, 0.5);
      const std::uint32_t columns = 2 + random.index(20), rows = 2 + random.index(20);
      const Vec3 origin = {-spacing * static_cast<float>(columns) / 2, 0,
                           -spacing * static_cast<float>(rows) / 2};
      const HeightField field =
          make_hills(random, columns, rows, origin, spacing, 0.5, round % 3 ? 0 : 0.1).build();
      ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 3, 0.6, random.point(0.7))));
      ++(asked.expect_as_brute_force(field) > 0 ? apart : touching);
    }
    EXPECT_GT(touching, 3);
    EXPECT_GT(apart, 10);
  });
}

/// All triangles of the ground have the same distance; the lowest numbers are returned.
TEST(FieldDistance, LevelGroundHasTies) {
  const Shape limb = test::make_limb(10, 6, 3);
  Pose pose(*build_model(limb.view()));
  Asked asked{limb, pose};
  for (const Vec3& origin : {Vec3{-3, -2, -3}, Vec3{-3, 3, -3}, Vec3{5, 0, 5}})
    EXPECT_GT(asked.expect_as_brute_force(make_plain(13, 13, origin, 0.5f).build()), 0.5);
}

TEST(FieldDistance, AFieldOfHolesIsInfinitelyFar) {
  const Shape limb = test::make_limb(10, 6, 3);
  Pose pose(*build_model(limb.view()));
  test::Terrain holes = make_plain(9, 9, {-1, 0, -1}, 0.25f);
  for (float& height : holes.heights) height = NAN;
  Scratch scratch;
  Distance closest;
  distance(pose, holes.build(), scratch, closest);
  EXPECT_FALSE(closest);
}

TEST(FieldDistance, WorkDoesNotGrowWithTheField) {
  const Shape limb = test::make_limb(40, 12, 5);
  Scratch scratch;
  std::vector<std::uint64_t> pairs;
  for (const std::uint32_t side : {64u, 2048u}) {
    Pose pose(*build_model(limb.view()));
    const float first = -0.125f * static_cast<float>(side / 2);
    const HeightField field = make_plain(side, side, {first, -0.5f, first}, 0.125f).build();
    Distance closest;
    pairs.push_back(distance(pose, field, scratch, closest).triangle_pairs);
    EXPECT_EQ(closest.distance, 0.5);
  }
  EXPECT_EQ(pairs[0], pairs[1]);
}

}  // namespace
}  // namespace pelt
