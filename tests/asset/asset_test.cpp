#include "support/gltf_builder.hpp"

#include <pelt/asset.hpp>

#include "asset/read_gltf.hpp"
#include "asset/transform.hpp"

#include <gtest/gtest.h>

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

/// A skinned triangle on joint 0 and an unskinned one on a node of its own.
Asset skinned_and_riding(const Transform& riding) {
  Asset asset;
  asset.nodes = {{"hand", kNoParent, {.translation = {1, 2, 3}}, false, {}},
                 {"sword", 0, riding, false, {}}};
  asset.joints = {{0, {}}, {1, {}}};
  asset.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {0, 3, 1}};
  asset.triangles = {{0, 1, 2}, {3, 4, 5}};
  asset.joint_indices = {0, 0, 0, 1, 1, 1};
  asset.weights = {1, 1, 1, 1, 1, 1};
  asset.parts = {{"hand", "", "", 0, 1, true}, {"sword", "", "", 1, 1, false}};
  return asset;
}

Transform some_transform() {
  return {.translation = {5, -1, 0.5f}, .rotation = {0.6f, 0, 0.8f, 0}, .scale = {2, 0.5f, -3}};
}

Vec3 posed(const Asset& asset, std::uint32_t vertex) {
  SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  sample_palette(asset, nullptr, 0, Matrix4{}, scratch, palette);
  const auto& m = palette[asset.joint_indices[vertex]].m;
  const Vec3& p = asset.rest_positions[vertex];
  const auto row = [&](std::size_t r) {
    return m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r];
  };
  return {row(0), row(1), row(2)};
}

void expect_position(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-5);
  EXPECT_NEAR(a.y, b.y, 1e-5);
  EXPECT_NEAR(a.z, b.z, 1e-5);
}

TEST(Assemble, RestPositionsOfRidingPartsAreWhereTheDefaultPoseHasThem) {
  const Asset before = skinned_and_riding(some_transform());
  Asset after = before;
  assemble(after);
  for (std::uint32_t v = 3; v < 6; ++v) {
    expect_position(after.rest_positions[v], posed(before, v));
    expect_position(posed(after, v), posed(before, v));
  }
}

TEST(Assemble, ARidingPartFollowsItsNode) {
  Asset before = skinned_and_riding(some_transform());
  Asset after = before;
  assemble(after);
  before.nodes[0].local.translation = after.nodes[0].local.translation = {-3, 0, 7};
  before.nodes[1].local.rotation = after.nodes[1].local.rotation = {0, 0.6f, 0, 0.8f};
  for (std::uint32_t v = 3; v < 6; ++v) expect_position(posed(after, v), posed(before, v));
}

TEST(Assemble, SkinnedPartsStayBitForBit) {
  const Asset before = skinned_and_riding(some_transform());
  Asset after = before;
  assemble(after);
  for (std::uint32_t v = 0; v < 3; ++v)
    EXPECT_EQ(after.rest_positions[v], before.rest_positions[v]);
  EXPECT_EQ(after.joints[0].inverse_bind, before.joints[0].inverse_bind);
}

TEST(Assemble, LeavesWhatASkinSharesOrWhatHasNoInverse) {
  Asset shared = skinned_and_riding(some_transform());
  shared.joint_indices[2] = 1;
  Asset flat = skinned_and_riding({.scale = {1, 0, 1}});
  for (Asset* asset : {&shared, &flat}) {
    const Asset before = *asset;
    assemble(*asset);
    EXPECT_EQ(asset->rest_positions, before.rest_positions);
    EXPECT_EQ(asset->joints[1].inverse_bind, before.joints[1].inverse_bind);
  }
}

TEST(Inverted, TimesTheMapIsTheIdentity) {
  const Affine map = {2, 0.5, -1, 0, -3, 0.25, 1, 1, 4, 10, -20, 30};
  const std::optional<Affine> inverse = inverted(map);
  ASSERT_TRUE(inverse);
  const Affine identity = affine_of(Matrix4{});
  for (const Affine& product : {map * *inverse, *inverse * map})
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(product[i], identity[i], 1e-12);
  EXPECT_FALSE(inverted({1, 2, 3, 2, 4, 6, 0, 0, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace pelt::asset
