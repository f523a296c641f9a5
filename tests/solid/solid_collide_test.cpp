#include <pelt/bounds.hpp>
#include <pelt/solid.hpp>

#include "solid/random_regions.hpp"
#include "solid/region_oracle.hpp"
#include "support/animated_character.hpp"
#include "support/random.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pelt {
namespace {

using test::Random;
using test::RandomRegions;
using test::Shape;

/// Queries of one pose, and the answers of brute force.
struct Asked {
  Asked(const Shape& s, Pose& p) : shape(s), pose(p), positions(s.rest_positions.size()) {
    posed_vertices(pose, positions);
  }

  Placement expect_as_brute_force(const Region& region) {
    const TrianglesInRegion expected = test::brute_force(region, shape.triangles, positions);
    const Placement placement = test::placement_of(expected, shape.triangles.size());
    EXPECT_EQ(test::placement_of(pose, region, scratch), placement);
    found = test::triangles_in(pose, region, scratch);
    EXPECT_EQ(found.intersecting, expected.intersecting);
    EXPECT_EQ(found.inside, expected.inside);
    EXPECT_EQ(test::placement_of(pose, region, scratch), placement);
    touching = {UINT32_MAX};
    collide(pose, region, scratch, touching);
    EXPECT_EQ(touching.front(), UINT32_MAX);
    touching.erase(touching.begin());
    EXPECT_EQ(touching, expected.intersecting);
    EXPECT_EQ(intersects(pose, region, scratch).answer, !touching.empty());
    return placement;
  }

  const Shape& shape;
  Pose& pose;
  std::vector<Vec3> positions;
  Scratch scratch;
  TrianglesInRegion found = {{7}, {7}};
  std::vector<std::uint32_t> touching;
};

/// Faces and spheres through vertices, which only exact arithmetic can decide.
TEST(Region, TouchingCounts) {
  Random random(542);
  const Shape limb = test::make_limb(20, 8, 3);
  Pose pose(*build_model(limb.view()));
  ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 3, 0.5, random.point(1))));
  Asked asked(limb, pose);
  Vec3 lowest = asked.positions[0];
  for (const Vec3& p : asked.positions)
    if (p.y < lowest.y) lowest = p;
  const float below = std::nextafter(lowest.y, -100.0f);
  EXPECT_EQ(asked.expect_as_brute_force(HalfSpace{{0, 1, 0}, lowest.y}), Placement::partly);
  EXPECT_EQ(asked.expect_as_brute_force(HalfSpace{{0, 1, 0}, below}), Placement::outside);
  EXPECT_EQ(asked.expect_as_brute_force(HalfSpace{{0, -1, 0}, -lowest.y}), Placement::inside);
  EXPECT_EQ(asked.expect_as_brute_force(Sphere{lowest, 0}), Placement::partly);
  EXPECT_EQ(asked.expect_as_brute_force(Box{lowest, lowest}), Placement::partly);
}

TEST(Region, BatchesGiveTheSameAndAddUpTheWork) {
  Random random(543);
  RandomRegions regions(random);
  const Shape limb = test::make_limb(20, 8, 4);
  const SkinnedModel model = *build_model(limb.view());
  std::vector<Pose> poses;
  for (int i = 0; i < 60; ++i) {
    poses.emplace_back(model);
    ASSERT_TRUE(poses.back().set_palette(test::bend_limb(random, 4, 0.4, random.point(3))));
  }
  std::vector<Pose*> pointers;
  for (Pose& pose : poses) pointers.push_back(&pose);
  Scratch scratch;
  std::array<int, 3> counts = {};
  for (int round = 0; round < 20; ++round) {
    const Region region = regions.next({}, 6);
    std::vector<Placement> placements(poses.size());
    const QueryStats all = classify(pointers, region, scratch, placements);
    QueryStats sum;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      Placement one = Placement::outside;
      sum += classify(poses[i], region, scratch, one);
      EXPECT_EQ(one, placements[i]);
      ++counts[static_cast<std::size_t>(placements[i])];
    }
    EXPECT_EQ(all.node_pairs, sum.node_pairs);
    EXPECT_EQ(all.triangle_pairs, sum.triangle_pairs);
  }
  for (const int count : counts) EXPECT_GT(count, 30);
}

TEST(Region, PlacementDecidedByTheRootBoxCostsOneBox) {
  Random random(544);
  const Shape limb = test::make_limb(40, 12, 5);
  Pose pose(*build_model(limb.view()));
  Scratch scratch;
  for (const Region& region :
       {Region(Sphere{{50, 0, 0}, 10}), Region(Sphere{{0, 0, 0}, 100}),
        Region(Box{{20, 20, 20}, {30, 30, 30}}), Region(HalfSpace{{0, 1, 0}, 100})}) {
    ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 5, 0.5, {})));
    Placement placement = Placement::outside;
    const QueryStats stats = classify(pose, region, scratch, placement);
    EXPECT_EQ(stats.node_pairs, 1u);
    EXPECT_EQ(stats.refits, 1u);
    EXPECT_EQ(stats.posed_vertices, 0u);
  }
}

TEST(Placement, HasNames) {
  EXPECT_STREQ(name_of(Placement::outside), "outside");
  EXPECT_STREQ(name_of(Placement::partly), "partly");
  EXPECT_STREQ(name_of(Placement::inside), "inside");
}

// Real characters, and regions of all kinds.

using SharedRegions = test::OfSharedModels<>;

/// A point inside the box or slightly outside.
Vec3 near_box(Random& random, const Box& box) {
  const auto between = [&](float low, float high) {
    return low + (high - low) * random.uniformf(-0.2, 1.2);
  };
  return {between(box.low.x, box.high.x), between(box.low.y, box.high.y),
          between(box.low.z, box.high.z)};
}

TEST_P(SharedRegions, EqualBruteForce) {
  const asset::Asset& asset = character->asset;
  Pose& pose = character->pose;
  Random random(560);
  Scratch scratch;
  std::vector<Vec3> positions(pose.model().vertex_count());
  std::array<int, 3> counts = {};
  for (int round = 0; round < 8; ++round) {
    const auto& clip = asset.clips[random.index(static_cast<std::uint32_t>(asset.clips.size()))];
    character->move(&clip, clip.duration * random.uniformf(0, 1));
    posed_vertices(pose, positions);
    const Box box = test::bounds_of(pose).box;
    const float size = box.high.y - box.low.y;
    const Vec3 a = near_box(random, box), b = near_box(random, box), n = random.point(1);
    const HalfSpace half = {n, n.x * a.x + n.y * a.y + n.z * a.z};
    const Region regions[] = {
        half,
        Box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
            {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}},
        Sphere{a, size * random.uniformf(0, 0.6)},
        Sphere{a, 3 * size},
        Capsule{a, b, size * random.uniformf(0, 0.3)},
        OrientedBox{a,
                    {Vec3{0.6f, 0.8f, 0}, Vec3{-0.8f, 0.6f, 0}, Vec3{0, 0, 1}},
                    {size * 0.2f, size * 0.1f, size * 0.4f}}};
    for (const Region& region : regions) {
      const TrianglesInRegion expected = test::brute_force(region, asset.triangles, positions);
      const Placement placement = test::placement_of(expected, asset.triangles.size());
      EXPECT_EQ(test::placement_of(pose, region, scratch), placement);
      const TrianglesInRegion found = test::triangles_in(pose, region, scratch);
      EXPECT_EQ(found.intersecting, expected.intersecting);
      EXPECT_EQ(found.inside, expected.inside);
      ++counts[static_cast<std::size_t>(placement)];
    }
  }
  EXPECT_GT(counts[1], 10);
  EXPECT_GT(counts[2], 5);
}

INSTANTIATE_TEST_SUITE_P(Models, SharedRegions,
                         testing::Values("human.glb", "knight.glb", "fox_khronos.glb"));

}  // namespace
}  // namespace pelt
