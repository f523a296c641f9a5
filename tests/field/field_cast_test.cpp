#include "fields.hpp"
#include "geometry/ray_triangle.hpp"
#include "support/allocation_count.hpp"
#include "support/values.hpp"

#include <limits>

namespace pelt {
namespace {

using test::make_hills;
using test::make_plain;
using test::Random;

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
