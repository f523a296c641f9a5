#include <pelt/asset.hpp>
#include <pelt/pelt.hpp>

#include "asset/read_gltf.hpp"
#include "asset/transform.hpp"
#include "support/gltf_builder.hpp"

#include <gtest/gtest.h>

namespace pelt::asset {
namespace {

TEST(Asset, MeshBorrowsTheArrays) {
  const Asset asset = test::paper_strip().read();
  const SkinnedMeshView mesh = asset.mesh();
  EXPECT_EQ(mesh.rest_positions.data(), asset.rest_positions.data());
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

// The real characters of the shared folder load and have the sizes in this table.

namespace fs = std::filesystem;

const fs::path kModels = fs::path(PELT_SHARED_DIR) / "models";

struct Expected {
  const char* file;
  std::size_t vertices, triangles;  ///< of the skinned meshes
  std::size_t palette;              ///< joints of all skins, each once
  std::size_t clips;
  std::uint32_t influences;
  std::size_t parts, triangles_of_all;  ///< including unskinned meshes
};

constexpr Expected kExpected[] = {
    {"barbarian.glb", 3342, 4045, 41, 16, 4, 13, 6543},
    {"cesium_man.glb", 3273, 4672, 19, 1, 4, 1, 4672},
    {"cyber_character.glb", 7778, 7520, 75, 22, 4, 10, 7520},
    {"cyber_enemy_large.glb", 5816, 4256, 30, 8, 2, 9, 4256},
    {"fox_khronos.glb", 1728, 576, 24, 3, 4, 1, 576},
    {"fox_m2m.glb", 1250, 1654, 49, 14, 4, 1, 1654},
    {"frog.glb", 9840, 4920, 28, 4, 4, 4, 4920},
    {"human.glb", 13380, 26756, 163, 14, 4, 1, 26756},
    {"human_8inf.glb", 13380, 26756, 163, 2, 8, 1, 26756},
    {"human_hi.glb", 53514, 107024, 163, 14, 4, 1, 107024},
    {"kaiju.glb", 1561, 2318, 58, 10, 4, 1, 2318},
    {"knight.glb", 3716, 4148, 41, 16, 4, 15, 6952},
    {"mannequin.glb", 8691, 13721, 53, 14, 4, 3, 13721},
    {"mech_george.glb", 7755, 7864, 47, 20, 3, 1, 7864},
    {"robot_expressive.glb", 1108, 544, 43, 14, 4, 19, 3237},
    {"simple_skin.gltf", 10, 8, 2, 1, 2, 1, 8},
    {"sintel.glb", 25413, 41306, 66, 5, 4, 4, 41306},
    {"spider.glb", 924, 1600, 56, 10, 4, 1, 1600},
};

class SharedModels : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(PELT_SHARED_DIR)) GTEST_SKIP() << PELT_SHARED_DIR << " is not there";
  }
};

TEST_F(SharedModels, HaveWhatTheTableSays) {
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    GltfOptions options;
    options.unskinned_parts = false;
    const Result<Asset> asset = load_gltf(kModels / expected.file, options);
    ASSERT_TRUE(asset) << asset.error().message;
    EXPECT_EQ(asset->rest_positions.size(), expected.vertices);
    EXPECT_EQ(asset->triangles.size(), expected.triangles);
    EXPECT_EQ(asset->joints.size(), expected.palette);
    EXPECT_EQ(asset->clips.size(), expected.clips);
    EXPECT_EQ(asset->influences_per_vertex, expected.influences);
  }
}

TEST_F(SharedModels, BecomeModelsWithTheirUnskinnedParts) {
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const Result<Asset> asset = load_gltf(kModels / expected.file);
    ASSERT_TRUE(asset) << asset.error().message;
    EXPECT_EQ(asset->parts.size(), expected.parts);
    EXPECT_EQ(asset->triangles.size(), expected.triangles_of_all);
    const Result<SkinnedModel> model = build_model(asset->mesh());
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->triangle_count(), expected.triangles_of_all);
  }
}

TEST_F(SharedModels, LoadWithoutASkin) {
  const Result<Asset> asset = load_gltf(kModels / "morph_stress.glb");
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_EQ(asset->joints.size(), 1u);
  EXPECT_EQ(asset->clips.size(), 3u);
  EXPECT_TRUE(asset->warnings.empty());
  EXPECT_EQ(asset->morph_targets.size(), 8u);
  EXPECT_TRUE(build_model(asset->mesh()));
}

/// In this export, all sparse values of the face are zero.
TEST_F(SharedModels, MayHaveMorphTargetsThatDisplaceNothing) {
  const Result<Asset> asset = load_gltf(kModels / "sintel.glb");
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_EQ(asset->morph_targets.size(), 40u);
  EXPECT_TRUE(asset->morph_vertices.empty());
}

TEST_F(SharedModels, PlayTheirMorphTargets) {
  const Result<Asset> asset = load_gltf(kModels / "morph_stress.glb");
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_GT(asset->morph_vertices.size(), 500u);
  Pose pose(*build_model(asset->mesh()));
  std::vector<float> weights(asset->morph_targets.size());
  int active = 0;
  for (const Clip& clip : asset->clips)
    for (const float share : {0.1f, 0.4f, 0.8f}) {
      sample_morph_weights(*asset, &clip, share * clip.duration, weights);
      ASSERT_TRUE(pose.set_morph_weights(weights));
      EXPECT_EQ(check_bounds(pose), "");
      for (const float weight : weights) active += weight != 0;
    }
  EXPECT_GT(active, 5);
}

TEST_F(SharedModels, AreRefusedWhereWeightsAreNotNumbers) {
  const Result<Asset> asset = load_gltf(kModels / "broken" / "wasp_nan_weights.glb");
  EXPECT_TRUE(test::refused(asset, {"wasp_nan_weights.glb", "node 41 \"Wasp\"", "accessor 2",
                                    "WEIGHTS_0", "element 2240 is NaN"}));
}

TEST_F(SharedModels, AreRefusedWhereWeightsDoNotSumToOne) {
  const Result<Asset> asset = load_gltf(kModels / "broken" / "human_weights_not_normalised.glb");
  ASSERT_TRUE(asset) << asset.error().message;
  const Result<SkinnedModel> model = build_model(asset->mesh());
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find("weights of vertex 541"), std::string::npos)
      << model.error().message;
  EXPECT_NE(model.error().message.find("sum"), std::string::npos) << model.error().message;
  ModelOptions options;
  options.off_weights = OffWeights::renormalise;
  EXPECT_TRUE(build_model(asset->mesh(), options));
}

}  // namespace
}  // namespace pelt::asset
