#include "tools/pelt/scene/scene_glb.hpp"

#include <pelt/asset.hpp>

#include "tools/glb_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace pelt::tools::scene {
namespace {

/// Values whose bits a careless writer would change.
const std::vector<Vec3> kPositions = {{0.1f, -0.0f, 1e-42f},
                                      {std::numeric_limits<float>::max(), 1.0f / 3, 5},
                                      {-7, 16777216, std::numeric_limits<float>::min()},
                                      {1, 2, 3}};
const std::vector<Triangle> kTriangles = {{0, 1, 2}, {2, 1, 0}, {3, 3, 3}};

std::vector<GlbMesh> two_meshes() {
  GlbMesh first{"first", kPositions, {}, {}};
  first.primitives.push_back({kTriangles, 0});
  GlbMesh second = first;
  second.name = "second";
  second.primitives.push_back({std::span(kTriangles).first(1), 1});
  return {first, second};
}

const std::vector<GlbMaterial> kMaterials = {{"dull", {0.5f, 0.5f, 0.5f}, {}},
                                             {"bright", {}, {1, 0, 0}}};

test::GlbFile parse(std::span<const std::byte> bytes) {
  return test::GlbFile({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

TEST(GlbWriter, WritesPositionsAndIndicesBitForBit) {
  GlbMesh mesh{"mesh", kPositions, {}, {}};
  mesh.primitives.push_back({kTriangles, 0});
  const test::GlbFile file = parse(make_glb(std::span(&mesh, 1), kMaterials));
  EXPECT_TRUE(test::same_bits(file.positions(0), kPositions));
  EXPECT_EQ(file.triangles(0), kTriangles);
}

TEST(GlbWriter, OwnReaderFindsTheSame) {
  const Result<asset::Asset> asset = asset::load_gltf(make_glb(two_meshes(), kMaterials), {});
  ASSERT_TRUE(asset) << asset.error().message;
  ASSERT_EQ(asset->rest_positions.size(), 2 * kPositions.size());
  for (std::size_t v = 0; v < asset->rest_positions.size(); ++v) {
    EXPECT_EQ(asset->rest_positions[v], kPositions[v % kPositions.size()]) << v;
  }
  ASSERT_EQ(asset->triangles.size(), 7u);
  EXPECT_TRUE(std::equal(kTriangles.begin(), kTriangles.end(), asset->triangles.begin()));
  ASSERT_EQ(asset->parts.size(), 3u);
  EXPECT_EQ(asset->parts[0].node, "first");
  EXPECT_EQ(asset->parts[2].material, "bright");
}

TEST(GlbWriter, KeepsTheRulesOfTheContainer) {
  const test::GlbFile file = parse(make_glb(two_meshes(), kMaterials));
  EXPECT_EQ(file.word(0), 0x46546C67u);
  EXPECT_EQ(file.word(4), 2u);
  EXPECT_EQ(file.word(8), file.size());
  const std::size_t json_size = file.word(12);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(file.word(16), 0x4E4F534Au);
  EXPECT_EQ(file.word(20 + json_size) % 4, 0u);
  EXPECT_EQ(file.word(24 + json_size), 0x004E4942u);
  EXPECT_EQ(28 + json_size + file.word(20 + json_size), file.size());
}

TEST(GlbWriter, KeepsTheRulesOfTheDocument) {
  const nlohmann::json json = parse(make_glb(two_meshes(), kMaterials)).document;
  EXPECT_EQ(json["scenes"][0]["nodes"], nlohmann::json({0, 1}));
  for (const auto& node : json["nodes"]) {
    for (const char* key : {"matrix", "translation", "rotation", "scale", "children"}) {
      EXPECT_FALSE(node.contains(key));
    }
  }
  const auto& positions =
      json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()];
  EXPECT_EQ(positions["min"][0].get<float>(), -7);
  EXPECT_EQ(positions["max"][0].get<float>(), std::numeric_limits<float>::max());
  EXPECT_EQ(positions["max"][1].get<float>(), 16777216);
  for (const auto& view : json["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
}

}  // namespace
}  // namespace pelt::tools::scene
