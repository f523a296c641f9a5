/// Real characters that walk on generated terrain.

#include "fields.hpp"
#include "support/values.hpp"

#include <pelt/asset.hpp>
#include <pelt/bounds.hpp>

#include <filesystem>

namespace pelt {
namespace {

using test::Random;

class SharedFields : public testing::TestWithParam<const char*> {};

TEST_P(SharedFields, EqualBruteForce) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Pose pose(*build_model(asset->mesh(), {.off_weights = OffWeights::renormalise}));
  Random random(710);
  Scratch scratch;
  asset::SampleScratch sampling;
  std::vector<Matrix4> palette(pose.model().joint_count());
  std::vector<Vec3> positions(pose.model().vertex_count());
  std::size_t hits = 0;
  const asset::Clip& clip = asset->clips.front();
  for (int step = 0; step < 3; ++step) {
    sample_palette(*asset, &clip, clip.duration * static_cast<float>(step) / 3, {}, sampling,
                   palette);
    ASSERT_TRUE(pose.set_palette(palette));
    posed_vertices(pose, positions);
    const Box box = test::bounds_of(pose).box;
    const float size = box.high.y - box.low.y, spacing = size / 14;
    const Vec3 origin = {(box.low.x + box.high.x) / 2 - 12 * spacing, box.low.y + size / 20,
                         (box.low.z + box.high.z) / 2 - 12 * spacing};
    const HeightField field =
        test::make_hills(random, 25, 25, origin, spacing, size / 10, 0.01).build();
    const auto expected = test::brute_force(field, asset->triangles, positions);
    std::vector<Contact> contacts;
    collide(pose, field, scratch, contacts);
    EXPECT_EQ(contacts, expected);
    hits += contacts.size();
  }
  EXPECT_GT(hits, 50u);
}

INSTANTIATE_TEST_SUITE_P(Models, SharedFields,
                         testing::Values("human.glb", "knight.glb", "fox_khronos.glb"));

}  // namespace
}  // namespace pelt
