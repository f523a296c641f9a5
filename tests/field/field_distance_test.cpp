#include "distance/brute_distance.hpp"
#include "field/fields.hpp"
#include "geometry/ray_triangle.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"

#include <limits>

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

/// Tests all triangles one by one.
RayHit brute_force(const HeightField& field, const Ray& ray, Facing facing) {
  RayHit best;
  for (std::uint32_t t = 0; t < field.triangle_count(); ++t) {
    const detail::TriangleCorners corners = field.triangle(t);
    detail::RayCrossing crossing;
    const detail::RayLine line = {ray.origin, ray.direction};
    if (test::is_hole(corners) || !line_meets_triangle(line, corners, crossing)) continue;
    if (crossing.t < ray.t_min || crossing.t > ray.t_max) continue;
    if (facing != Facing::both && crossing.from_front != (facing == Facing::front)) continue;
    if (best && best.t <= crossing.t) continue;
    best = {t,
            {},
            crossing.t,
            detail::crossing_weights(line, corners, crossing),
            detail::unit_normal(corners)};
  }
  return best;
}

/// Returns whether the ray hits.
bool expect_as_brute_force(const HeightField& field, const Ray& ray, Facing facing = Facing::both) {
  const RayHit expected = brute_force(field, ray, facing);
  EXPECT_EQ(test::first_hit(field, ray, facing), expected);
  return bool(expected);
}

TEST(FieldCast, EqualsBruteForce) {
  Random random(730);
  int hits = 0, misses = 0;
  for (int round = 0; round < 30; ++round) {
    const std::uint32_t columns = 2 + random.index(30), rows = 2 + random.index(30);
    const Vec3 origin = random.point(round % 5 ? 1 : 1e5);
    const HeightField field =
        make_hills(random, columns, rows, origin, 0.5f, 1, round % 3 ? 0 : 0.1).build();
    const auto somewhere = [&](double height) {
      return Vec3{origin.x + 0.5f * static_cast<float>(columns) * random.uniformf(-0.1, 1.1),
                  origin.y + random.uniformf(-height, height),
                  origin.z + 0.5f * static_cast<float>(rows) * random.uniformf(-0.1, 1.1)};
    };
    for (int i = 0; i < 40; ++i) {
      Ray ray = segment(somewhere(3), somewhere(1));
      if (random.chance(0.5)) ray.t_max = std::numeric_limits<float>::infinity();
      if (random.chance(0.2)) ray.t_min = -std::numeric_limits<float>::infinity();
      const auto facing = static_cast<Facing>(random.index(3));
      ++(expect_as_brute_force(field, ray, facing) ? hits : misses);
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 300);
}

/// Straight down and along diagonals, through vertices, edges, borders and corners of the field.
TEST(FieldCast, NothingSlipsBetweenTriangles) {
  Random random(731);
  const HeightField plain = make_plain(14, 11, {}, 1).build();
  const HeightField hills = make_hills(random, 14, 11, {}, 1, 0.5, 0).build();
  const auto half = [&](std::uint32_t count) {
    return static_cast<float>(random.index(2 * count - 1)) / 2;
  };
  for (int round = 0; round < 400; ++round) {
    const Vec3 at = {half(14), 0, half(11)};
    const Vec3 above = {at.x, 4, at.z};
    EXPECT_TRUE(expect_as_brute_force(hills, {above, {0, -1, 0}}));
    EXPECT_TRUE(expect_as_brute_force(plain, segment(above, at)));
    EXPECT_TRUE(expect_as_brute_force(plain, segment({half(14), 4, half(11)}, at)));
    expect_as_brute_force(hills, segment({half(14), 4, half(11)}, at));
    expect_as_brute_force(plain, {at, {half(5) - 1, 0, half(5) - 1}});  // in its plane: no hit
  }
}

TEST(FieldCast, BatchesGiveTheSameAndAllocateNothing) {
  Random random(732);
  const HeightField field = make_hills(random, 200, 200, {-10, 0, -10}, 0.1f, 0.5, 0.01).build();
  std::vector<Ray> rays;
  for (int i = 0; i < 200; ++i) {
    const Vec3 from = random.point(10), to = random.point(10);
    rays.push_back(segment({from.x, 3, from.z}, {to.x, 0, to.z}));
    rays.back().t_max = 100;
  }
  std::vector<RayHit> hits(rays.size());
  const std::size_t before = test::allocation_count();
  const QueryStats stats = cast(field, rays, hits);
  EXPECT_EQ(test::allocation_count(), before);
  std::size_t found = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(test::first_hit(field, rays[i]), hits[i]);
    found += bool(hits[i]);
  }
  EXPECT_GT(found, 100u);
  EXPECT_LT(stats.triangle_pairs, 200 * rays.size());
}

}  // namespace
}  // namespace pelt
