#include "support/gltf_builder.hpp"

#include <pelt/asset.hpp>

namespace pelt::asset {
namespace {

TEST(Asset, MeshBorrowsTheArrays) {
  const Result<Asset> asset = test::paper_strip().load();
  ASSERT_TRUE(asset) << asset.error().message;
  const SkinnedMeshView mesh = asset->mesh();
  EXPECT_EQ(mesh.rest_positions.data(), asset->rest_positions.data());
  EXPECT_EQ(mesh.rest_positions.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 6u);
  EXPECT_EQ(mesh.influences_per_vertex, 2u);
  EXPECT_EQ(mesh.joints.size(), 16u);
  EXPECT_EQ(mesh.weights.size(), 16u);
  EXPECT_EQ(mesh.joint_count, 2u);
}

TEST(Asset, FindsTheFirstClipOfAName) {
  Asset asset;
  asset.clips.resize(3);
  asset.clips[0].name = "walk";
  asset.clips[2].name = "walk";
  EXPECT_EQ(asset.find_clip("walk"), &asset.clips[0]);
  EXPECT_EQ(asset.find_clip(""), &asset.clips[1]);
  EXPECT_EQ(asset.find_clip("run"), nullptr);
}

TEST(Asset, FindsThePartOfEveryTriangle) {
  Asset asset;
  asset.triangles.resize(6);
  asset.parts.resize(3);
  const std::uint32_t kFirst[] = {0, 1, 4};
  for (std::size_t i = 0; i < 3; ++i) asset.parts[i].first_triangle = kFirst[i];
  const std::size_t kPart[] = {0, 1, 1, 1, 2, 2};
  for (std::uint32_t t = 0; t < 6; ++t) EXPECT_EQ(&asset.part_of(t), &asset.parts[kPart[t]]);
}

}  // namespace
}  // namespace pelt::asset
