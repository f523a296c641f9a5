/// A moving character against regions, against the exact test of all triangles.

#include "collide/moving_bodies.hpp"
#include "solid/prepared_region.hpp"
#include "solid/random_regions.hpp"
#include "solid/region_triangle.hpp"

#include <pelt/solid.hpp>

namespace pelt::test {
namespace {

std::vector<RegionEntry> entries_of(Body& body, const Region& region,
                                    const MovingOptions& options = {}) {
  Scratch scratch;
  std::vector<RegionEntry> entries;
  collide(body.step(), region, scratch, entries, options);
  return entries;
}

std::vector<std::uint32_t> triangles_of(const std::vector<RegionEntry>& entries) {
  std::vector<std::uint32_t> triangles(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) triangles[i] = entries[i].triangle;
  return triangles;
}

std::vector<std::uint32_t> triangles_at(Pose& pose, const Region& region) {
  Scratch scratch;
  std::vector<std::uint32_t> triangles;
  collide(pose, region, scratch, triangles);
  return triangles;
}

/// A bending limb that moves near a region, into it or through it.
struct Walk {
  explicit Walk(Random& random) : regions(random) {
    const auto palette = [&] {
      const double angle = random.uniform(-0.4, 0.4);
      return bend_limb(random, 3, angle, random.point(0.6));
    };
    first = palette();
    last = palette();
    limb.move(first, last);
    region = regions.next({0, 0.5f, 0}, random.chance(0.3) ? 2 : 0.5);
  }

  RandomRegions regions;
  Body limb = Body(make_limb(10, 6, 3));
  std::vector<Matrix4> first, last;
  Region region;
};

TEST(MovingSolid, HasTheSameTrianglesBackwards) {
  Random random(1873);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    Walk walk(random);
    const auto forwards = triangles_of(entries_of(walk.limb, walk.region, {.times = false}));
    walk.limb.move(walk.last, walk.first);
    EXPECT_EQ(triangles_of(entries_of(walk.limb, walk.region, {.times = false})), forwards);
    found += forwards.size();
  }
  EXPECT_GT(found, 1000u);
}

TEST(MovingSolid, OfAStillCharacterIsCollide) {
  Random random(1874);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    Walk walk(random);
    Scratch scratch;
    std::vector<RegionEntry> entries;
    collide({walk.limb.from, walk.limb.from}, walk.region, scratch, entries);
    EXPECT_EQ(triangles_of(entries), triangles_at(walk.limb.from, walk.region));
    for (const RegionEntry& entry : entries) EXPECT_TRUE(entry.at_start);
    found += entries.size();
  }
  EXPECT_GT(found, 500u);
}

std::vector<Matrix4> at_height(float y) {
  std::vector<Matrix4> palette(3);
  for (Matrix4& m : palette) m.m[13] = y;
  return palette;
}

/// A limb that goes through a thin plate, a ball and a bar from one frame to the next.
TEST(MovingSolid, FindsWhatNoEndOfTheStepShows) {
  Body limb(make_limb(10, 6, 3));
  limb.move(at_height(0.5f), at_height(-2));
  for (const Region& region :
       {Region(Box{{-9, -0.1f, -9}, {9, -0.09f, 9}}), Region(Sphere{{0, -0.2f, 0}, 0.1f}),
        Region(Capsule{{-9, -0.2f, 0}, {9, -0.2f, 0}, 0.05f})}) {
    EXPECT_TRUE(triangles_at(limb.from, region).empty());
    EXPECT_TRUE(triangles_at(limb.to, region).empty());
    EXPECT_GT(entries_of(limb, region).size(), 5u);
  }
}

/// Faces that the lowest vertices reach exactly at the end, or miss by one float.
TEST(MovingSolid, TouchingAtOneInstantCounts) {
  Body limb(make_limb(10, 6, 3));
  limb.move(at_height(2), at_height(1));
  std::vector<Vec3> positions(limb.shape.rest_positions.size());
  posed_vertices(limb.to, positions);
  float lowest = positions[0].y;
  for (const Vec3& p : positions) lowest = std::min(lowest, p.y);
  const auto entries = entries_of(limb, HalfSpace{{0, 1, 0}, lowest});
  EXPECT_FALSE(entries.empty());
  for (const RegionEntry& entry : entries) EXPECT_EQ(entry.time, 1);
  EXPECT_TRUE(entries_of(limb, HalfSpace{{0, 1, 0}, std::nextafter(lowest, lowest - 1)}).empty());
}

TEST(MovingSolid, DecidedByTheRootBoxesPosesNothing) {
  Body limb(make_limb(40, 12, 5));
  Random random(1877);
  const auto from = bend_limb(random, 5, 0.4, {}), to = bend_limb(random, 5, 0.4, {});
  const auto expect_entries = [&](const Region& region, std::size_t count) {
    limb.move(from, to);
    Scratch scratch;
    std::vector<RegionEntry> entries;
    const MovingStats stats = collide(limb.step(), region, scratch, entries);
    EXPECT_EQ(stats.node_pairs, 1u);
    EXPECT_EQ(stats.posed_vertices, 0u);
    EXPECT_EQ(entries.size(), count);
  };
  expect_entries(Sphere{{50, 0, 0}, 10}, 0);
  expect_entries(Sphere{{0, 0, 0}, 100}, limb.shape.triangles.size());
}

}  // namespace
}  // namespace pelt::test
