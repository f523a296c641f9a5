/// Real characters, and regions of all kinds.

#include <pelt/asset.hpp>
#include <pelt/bounds.hpp>
#include <pelt/solid.hpp>

#include "solid/region_oracle.hpp"
#include "support/random.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace pelt {
namespace {

using test::Random;

class SharedRegions : public testing::TestWithParam<const char*> {};

/// A point inside the box or slightly outside.
Vec3 near_box(Random& random, const Box& box) {
  const auto between = [&](float low, float high) {
    return low + (high - low) * random.uniformf(-0.2, 1.2);
  };
  return {between(box.low.x, box.high.x), between(box.low.y, box.high.y),
          between(box.low.z, box.high.z)};
}

TEST_P(SharedRegions, EqualBruteForce) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Pose pose(*build_model(asset->mesh(), {.off_weights = OffWeights::renormalise}));
  Random random(560);
  Scratch scratch;
  asset::SampleScratch sampling;
  std::vector<Matrix4> palette(pose.model().joint_count());
  std::vector<Vec3> positions(pose.model().vertex_count());
  std::array<int, 3> counts = {};
  for (int round = 0; round < 8; ++round) {
    const auto& clip = asset->clips[random.index(static_cast<std::uint32_t>(asset->clips.size()))];
    sample_palette(*asset, &clip, clip.duration * random.uniformf(0, 1), {}, sampling, palette);
    ASSERT_TRUE(pose.set_palette(palette));
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
      const TrianglesInRegion expected = test::brute_force(region, asset->triangles, positions);
      const Placement placement = test::placement_of(expected, asset->triangles.size());
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
