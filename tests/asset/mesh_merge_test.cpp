#include "asset/mesh_merge.hpp"

#include "support/gltf_builder.hpp"

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

/// The strip with a stone as a child of "upper", and a pebble in a bag beside it.
GltfBuilder armed_strip() {
  GltfBuilder builder = test::paper_strip();
  const std::size_t positions =
      builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  builder.add("materials", {{"name", "granite"}});
  builder.add("meshes",
              {{"name", "rock"},
               {"primitives",
                json::array({{{"attributes", {{"POSITION", positions}}}, {"material", 0}}})}});
  builder.add("nodes", {{"name", "stone"}, {"mesh", 1}});
  builder.add("nodes", {{"name", "bag"}, {"children", {5}}});
  builder.add("nodes", {{"name", "pebble"}, {"mesh", 1}});
  builder.document["nodes"][2]["children"] = {3};
  builder.document["scenes"][0]["nodes"] = {1, 0, 4};
  return builder;
}

std::vector<std::string> part_nodes(const GltfBuilder& builder, const GltfOptions& options = {}) {
  std::vector<std::string> names;
  const Asset asset = builder.read(options);
  for (const Part& part : asset.parts) names.push_back(part.node);
  return names;
}

using Names = std::vector<std::string>;

TEST(MeshMerge, NumbersTrianglesInSceneOrder) {
  const Asset asset = armed_strip().read();
  ASSERT_EQ(asset.parts.size(), 3u);
  EXPECT_EQ(part_nodes(armed_strip()), (Names{"stone", "paper", "pebble"}));
  EXPECT_EQ(asset.parts[1].first_triangle, 1u);
  EXPECT_EQ(asset.parts[1].triangle_count, 6u);
  EXPECT_EQ(asset.parts[2].first_triangle, 7u);
  EXPECT_EQ(asset.triangles.size(), 8u);
  EXPECT_EQ(asset.triangles[1], (Triangle{3, 4, 5}));
  EXPECT_EQ(asset.triangles[7], (Triangle{11, 12, 13}));
}

TEST(MeshMerge, NamesItsParts) {
  const Asset asset = armed_strip().read();
  EXPECT_EQ(asset.parts[0].mesh, "rock");
  EXPECT_EQ(asset.parts[0].material, "granite");
  EXPECT_FALSE(asset.parts[0].skinned);
  EXPECT_EQ(asset.parts[1].mesh, "sheet");
  EXPECT_EQ(asset.parts[1].material, "");
  EXPECT_TRUE(asset.parts[1].skinned);
}

TEST(MeshMerge, UnskinnedPartsRideOnTheirNodes) {
  const Asset asset = armed_strip().read();
  ASSERT_EQ(asset.joints.size(), 4u);
  EXPECT_EQ(asset.joint_name(0), "stone");
  EXPECT_EQ(asset.joint_name(3), "pebble");
  EXPECT_EQ(asset.joints[0].inverse_bind.m[13], -1.5f) << "the inverse of its node's place";
  EXPECT_EQ(asset.joint_indices[0], 0);
  EXPECT_EQ(asset.weights[0], 1);
  EXPECT_EQ(asset.joint_indices.back(), 0);
  EXPECT_EQ(asset.joint_indices[asset.joint_indices.size() - 2], 3);
}

TEST(MeshMerge, LeavesUnskinnedPartsOutOnDemand) {
  GltfOptions options;
  options.unskinned_parts = false;
  const Asset asset = armed_strip().read(options);
  EXPECT_EQ(part_nodes(armed_strip(), options), Names{"paper"});
  EXPECT_EQ(asset.joints.size(), 2u);
  EXPECT_EQ(asset.nodes.size(), 6u);
}

TEST(MeshMerge, ExcludesNodesByNameWithTheirChildren) {
  GltfOptions options;
  options.exclude_nodes = {"stone"};
  EXPECT_EQ(part_nodes(armed_strip(), options), (Names{"paper", "pebble"}));
  options.exclude_nodes = {"bag", "paper"};
  EXPECT_EQ(part_nodes(armed_strip(), options), (Names{"stone"}));
  options.exclude_nodes = {"lower"};
  EXPECT_EQ(part_nodes(armed_strip(), options), (Names{"paper", "pebble"}));
}

TEST(MeshMerge, RefusesANameToExcludeThatNoNodeHas) {
  GltfOptions options;
  options.exclude_nodes = {"stone", "helmet"};
  const Result<Asset> asset = armed_strip().load(options);
  EXPECT_TRUE(refused(asset, {"\"helmet\"", "\"stone\", \"paper\", \"pebble\""}));
  EXPECT_EQ(asset.error().code, ErrorCode::invalid_argument);
}

TEST(MeshMerge, PassesOverANameToExcludeThatNeedNotExist) {
  GltfOptions options;
  options.exclude_nodes = {"stone", "helmet"};
  options.excluded_must_exist = false;
  EXPECT_EQ(part_nodes(armed_strip(), options), (Names{"paper", "pebble"}));
}

TEST(MeshMerge, RefusesASceneWithoutTriangles) {
  GltfOptions options;
  options.unskinned_parts = false;
  EXPECT_TRUE(refused(test::stone().load(options), {"no triangles"}));
  GltfBuilder builder = test::stone();
  builder.document["scenes"][0]["nodes"] = json::array();
  EXPECT_TRUE(refused(builder.load(), {"no triangles"}));
  EXPECT_EQ(builder.load().error().code, ErrorCode::unsupported);
}

TEST(MeshMerge, MeshesOfSeveralNodesBecomeSeveralParts) {
  GltfBuilder builder = test::stone();
  builder.add("nodes", {{"name", "twin"}, {"mesh", 0}});
  builder.document["scenes"][0]["nodes"] = {0, 1};
  const Asset asset = builder.read();
  EXPECT_EQ(part_nodes(builder), (Names{"stone", "twin"}));
  EXPECT_EQ(asset.rest_positions.size(), 6u);
  EXPECT_EQ(asset.joints.size(), 2u);
}

TEST(MeshMerge, PrimitivesThatShareTheirVerticesShareThem) {
  GltfBuilder builder = test::paper_strip();
  const std::size_t more = builder.add_accessor(std::vector<std::uint8_t>{7, 6, 5}, "SCALAR");
  json second = builder.primitive();
  second["indices"] = more;
  builder.document["meshes"][0]["primitives"].push_back(second);
  const Asset asset = builder.read();
  EXPECT_EQ(asset.rest_positions.size(), 8u);
  ASSERT_EQ(asset.parts.size(), 2u);
  EXPECT_EQ(asset.triangles.back(), (Triangle{7, 6, 5}));
}

TEST(MeshMerge, KeepsDegenerateTriangles) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<std::uint16_t>(0, 1, 0);
  EXPECT_EQ(builder.load()->triangles.size(), 6u);
  EXPECT_EQ(builder.load()->triangles[0], (Triangle{0, 0, 2}));
}

TEST(MeshMerge, MeshesWithJointsButNoSkinAreUnskinned) {
  GltfBuilder builder = test::paper_strip();
  builder.document["nodes"][0].erase("skin");
  const Asset asset = builder.read();
  EXPECT_FALSE(asset.parts[0].skinned);
  EXPECT_EQ(asset.influences_per_vertex, 1u);
}

TEST(MeshMerge, RefusesInstancesOutOfProportion) {
  constexpr int kNodes = 20000, kVertices = 3000;
  GltfBuilder builder;
  builder.add_accessor(std::vector<float>(3 * kVertices), "VEC3");
  builder.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  json nodes = json::array();
  for (int i = 0; i < kNodes; ++i) nodes.push_back({{"mesh", 0}});
  builder.document["nodes"] = nodes;
  EXPECT_TRUE(refused(builder.load(), {"node ", "mesh 0", "out of proportion"}));
}

TEST(MeshMerge, RefusesInfluencesOutOfProportion) {
  constexpr std::size_t kVertices = 30000;
  GltfBuilder builder = test::stone();
  builder.add_accessor(std::vector<float>(3 * kVertices), "VEC3");
  builder.attribute("POSITION") = 1;
  const std::size_t joints = builder.add_accessor(std::vector<std::uint8_t>(4 * kVertices), "VEC4");
  std::vector<std::uint8_t> few(4 * kVertices);
  few[0] = 255;
  const std::size_t weights = builder.add_accessor(few, "VEC4", true);
  for (int set = 0; set < 3000; ++set) {
    builder.attribute(("JOINTS_" + std::to_string(set)).c_str()) = joints;
    builder.attribute(("WEIGHTS_" + std::to_string(set)).c_str()) = weights;
  }
  builder.add("skins", {{"joints", {0}}});
  builder.document["nodes"][0]["skin"] = 0;
  EXPECT_TRUE(refused(builder.load(), {"out of proportion"}));
}

}  // namespace
}  // namespace pelt::asset
