/// The real characters of the shared folder load and have the sizes in this table.

#include "support/gltf_builder.hpp"

#include <pelt/pelt.hpp>

namespace pelt::asset {
namespace {

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
