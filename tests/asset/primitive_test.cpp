#include "asset/primitive.hpp"

#include "support/gltf_builder.hpp"

#include <pelt/model.hpp>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

using Triangles = std::vector<Triangle>;

/// Five points without indices, in a given drawing mode.
GltfBuilder five_points(int mode) {
  GltfBuilder builder = test::stone();
  builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3");
  builder.attribute("POSITION") = 1;
  builder.primitive()["mode"] = mode;
  return builder;
}

Triangles triangles(const GltfBuilder& builder) { return builder.read().triangles; }

TEST(Primitive, DrawsListsWithoutIndices) {
  EXPECT_EQ(triangles(test::stone()), (Triangles{{0, 1, 2}}));
}

TEST(Primitive, DrawsListsWithIndicesOfEverySize) {
  GltfBuilder builder = test::stone();
  builder.add_accessor(std::vector<std::uint8_t>{2, 1, 0, 0, 0, 1}, "SCALAR");
  builder.add_accessor(std::vector<std::uint16_t>{2, 1, 0, 0, 0, 1}, "SCALAR");
  builder.add_accessor(std::vector<std::uint32_t>{2, 1, 0, 0, 0, 1}, "SCALAR");
  for (const int accessor : {1, 2, 3}) {
    builder.primitive()["indices"] = accessor;
    EXPECT_EQ(triangles(builder), (Triangles{{2, 1, 0}, {0, 0, 1}}));
  }
}

TEST(Primitive, DrawsStripsWithAlternatingWinding) {
  EXPECT_EQ(triangles(five_points(5)), (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
}

TEST(Primitive, DrawsFansAroundTheFirstVertex) {
  EXPECT_EQ(triangles(five_points(6)), (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST(Primitive, DrawsStripsAndFansByIndices) {
  for (const int mode : {5, 6}) {
    GltfBuilder builder = five_points(mode);
    builder.add_accessor(std::vector<std::uint8_t>{4, 3, 2, 2}, "SCALAR");
    builder.primitive()["indices"] = 2;
    const Triangles strip = {{4, 3, 2}, {3, 2, 2}}, fan = {{3, 2, 4}, {2, 2, 4}};
    EXPECT_EQ(triangles(builder), mode == 5 ? strip : fan);
  }
}

TEST(Primitive, PassesOverPointsAndLinesWithAWarning) {
  for (const int mode : {0, 1, 2, 3}) {
    GltfBuilder builder = test::stone();
    json other = builder.primitive();
    other["mode"] = mode;
    builder.document["meshes"][0]["primitives"].push_back(other);
    const Asset asset = builder.read();
    EXPECT_EQ(asset.triangles.size(), 1u);
    ASSERT_EQ(asset.warnings.size(), 1u);
    EXPECT_EQ(asset.warnings[0], "mesh 0 \"rock\", primitive 1 is ignored: it has points or lines");
  }
}

TEST(Primitive, PassesOverOneWithoutPositions) {
  GltfBuilder builder = test::stone();
  builder.document["meshes"][0]["primitives"].push_back({{"attributes", json::object()}});
  const Asset asset = builder.read();
  EXPECT_EQ(asset.warnings[0], "mesh 0 \"rock\", primitive 1 is ignored: it has no POSITION");
}

TEST(Primitive, TooShortStripsHaveNoTriangles) {
  GltfBuilder builder = test::stone();
  for (const int count : {0, 1, 2}) {
    builder.accessor(0)["count"] = count;
    for (const int mode : {5, 6}) {
      builder.primitive()["mode"] = mode;
      EXPECT_TRUE(refused(builder.load(), {"the scene has no triangles"}));
    }
  }
}

TEST(Primitive, RefusesAListThatIsNoWholeNumberOfTriangles) {
  GltfBuilder builder = five_points(4);
  EXPECT_TRUE(refused(builder.load(),
                      {"node 0 \"stone\"", "mesh 0 \"rock\"", "primitive 0", "5 vertices"}));
}

TEST(Primitive, RefusesIndicesBeyondTheVertices) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<std::uint16_t>(0, 7, 8);
  EXPECT_TRUE(refused(builder.load(), {"accessor 0", "indices of mesh 0 \"sheet\", primitive 0",
                                       "index 7 is 8", "8 vertices"}));
}

TEST(Primitive, RefusesAttributesOfAnotherLength) {
  for (const int accessor : {2, 3}) {
    GltfBuilder builder = test::paper_strip();
    builder.accessor(static_cast<std::size_t>(accessor))["count"] = 7;
    EXPECT_TRUE(refused(builder.load(),
                        {"accessor " + std::to_string(accessor), "7 elements for 8 vertices"}));
  }
}

TEST(Influences, AreReadFromBytesAndShorts) {
  GltfBuilder builder = test::paper_strip();
  const std::vector<std::uint16_t> expected = builder.load()->joint_indices;
  std::vector<std::uint16_t> joints;
  for (int v = 0; v < 8; ++v) joints.insert(joints.end(), {0, 1, 0, 0});
  builder.attribute("JOINTS_0") = builder.add_accessor(joints, "VEC4");
  EXPECT_EQ(builder.load()->joint_indices, expected);
}

TEST(Influences, AreTrimmedToTheLargestNumberInUse) {
  const Asset asset = test::paper_strip().read();
  EXPECT_EQ(asset.influences_per_vertex, 2u);
  EXPECT_EQ(asset.weights, (std::vector<float>{1, 0, 1, 0, 0.75f, 0.25f, 0.75f, 0.25f, 0.5f, 0.5f,
                                               0.5f, 0.5f, 0.25f, 0.75f, 0.25f, 0.75f}));
  EXPECT_EQ(asset.joint_indices,
            (std::vector<std::uint16_t>{0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}));
}

TEST(Influences, OfAllSetsAreKeptInOrder) {
  GltfBuilder builder = test::paper_strip();
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (int v = 0; v < 8; ++v) {
    joints.insert(joints.end(), {1, 0, 1, 0});
    weights.insert(weights.end(), {0, 0.125f, 0, 0.25f});
  }
  for (const char* set : {"1", "2"}) {
    builder.attribute((std::string("JOINTS_") + set).c_str()) =
        builder.add_accessor(joints, "VEC4");
    builder.attribute((std::string("WEIGHTS_") + set).c_str()) =
        builder.add_accessor(weights, "VEC4");
  }
  const Asset asset = builder.read();
  ASSERT_EQ(asset.influences_per_vertex, 6u);
  const std::vector<float> last(asset.weights.end() - 6, asset.weights.end());
  EXPECT_EQ(last, (std::vector<float>{0.25f, 0.75f, 0.125f, 0.25f, 0.125f, 0.25f}));
}

TEST(Influences, ReadNormalisedWeights) {
  GltfBuilder builder = test::paper_strip();
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> shorts;
  for (int v = 0; v < 8; ++v) {
    bytes.insert(bytes.end(), {55, 200, 0, 0});
    shorts.insert(shorts.end(), {1, 65534, 0, 0});
  }
  builder.attribute("WEIGHTS_0") = builder.add_accessor(bytes, "VEC4", true);
  EXPECT_EQ(builder.load()->weights[0], 55 / 255.0f);
  EXPECT_EQ(builder.load()->weights[1], 200 / 255.0f);
  builder.attribute("WEIGHTS_0") = builder.add_accessor(shorts, "VEC4", true);
  EXPECT_EQ(builder.load()->weights[0], 1 / 65535.0f);
}

TEST(Influences, RefuseJointsBeyondTheSkinAlsoUnderZeroWeight) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<std::uint8_t>(2, 4 * 5 + 3, 2);
  EXPECT_TRUE(
      refused(builder.load(), {"node 0 \"paper\"", "accessor 2", "JOINTS_0 of mesh 0 \"sheet\"",
                               "vertex 5", "joint 2", "skin 0 \"rig\" has 2 joints"}));
}

TEST(Influences, RefuseWeightsThatAreNotNumbers) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<float>(3, 4 * 6 + 1, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(refused(builder.load(), {"accessor 3", "WEIGHTS_0", "element 6 is NaN"}));
}

TEST(Influences, AreNeededWhereThereIsASkin) {
  GltfBuilder builder = test::paper_strip();
  builder.primitive()["attributes"] = {{"POSITION", 1}};
  EXPECT_TRUE(
      refused(builder.load(), {"mesh 0 \"sheet\", primitive 0", "no JOINTS_0", "skin 0 \"rig\""}));
}

/// A stone with two morph targets: x + 1 and y + 1 for every vertex.
GltfBuilder morphing_stone() {
  GltfBuilder builder = test::stone();
  builder.add_accessor(std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
  builder.add_accessor(std::vector<std::int8_t>{0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3");
  builder.primitive()["targets"] = {{{"POSITION", 1}}, {{"NORMAL", 1}}, {{"POSITION", 2}}};
  return builder;
}

std::vector<float> default_weights(const Asset& asset) {
  std::vector<float> weights(asset.morph_targets.size());
  sample_morph_weights(asset, nullptr, 0, weights);
  return weights;
}

TEST(MorphTargets, AreReadAndHaveTheDefaultWeightsOfTheMesh) {
  GltfBuilder builder = morphing_stone();
  builder.document["meshes"][0]["weights"] = {0.5, 7, 2};
  builder.document["meshes"][0]["extras"] = {{"targetNames", {"wide", "odd"}}};
  const Asset asset = builder.read();
  EXPECT_EQ(asset.rest_positions[0], (Vec3{0, 0, 0}));
  EXPECT_EQ(asset.morph_begin, (std::vector<std::uint32_t>{0, 3, 3, 6}));
  EXPECT_EQ(asset.morph_vertices, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(asset.morph_displacements[2], (Vec3{1, 0, 0}));
  EXPECT_EQ(asset.morph_displacements[3], (Vec3{0, 1, 0}));
  EXPECT_EQ(asset.morph_targets[0].name, "wide");
  EXPECT_EQ(asset.morph_targets[2].name, "");
  EXPECT_EQ(asset.morph_targets[2].node, 0u);
  EXPECT_EQ(default_weights(asset), (std::vector<float>{0.5f, 7, 2}));
  EXPECT_TRUE(asset.warnings.empty());
  EXPECT_EQ(build_model(asset.mesh())->morph_target_count(), 3u);
}

TEST(MorphTargets, HaveTheWeightsOfTheNodeWhereItHasSome) {
  GltfBuilder builder = morphing_stone();
  builder.document["meshes"][0]["weights"] = {0.5, 0, 2};
  builder.document["nodes"][0]["weights"] = {-1};
  EXPECT_EQ(default_weights(*builder.load()), (std::vector<float>{-1, 0, 0}));
}

TEST(MorphTargets, AreNumberedNodeAfterNode) {
  GltfBuilder builder = morphing_stone();
  builder.add("nodes", {{"name", "other"}, {"mesh", 0}, {"weights", {1, 2, 3}}});
  builder.document["scenes"][0]["nodes"].push_back(1);
  const Asset asset = builder.read();
  ASSERT_EQ(asset.morph_targets.size(), 6u);
  EXPECT_EQ(asset.morph_targets[3].node, 1u);
  EXPECT_EQ(asset.morph_begin, (std::vector<std::uint32_t>{0, 3, 3, 6, 9, 9, 12}));
  EXPECT_EQ(asset.morph_vertices[6], 3u);
  EXPECT_EQ(default_weights(asset), (std::vector<float>{0, 0, 0, 1, 2, 3}));
}

/// Sparse displacements take memory only for the displaced vertices.
TEST(MorphTargets, KeepOnlyWhatMoves) {
  GltfBuilder builder = morphing_stone();
  builder.set_value<float>(1, 3, 0);
  const Asset asset = builder.read();
  EXPECT_EQ(asset.morph_vertices, (std::vector<std::uint32_t>{0, 2, 0, 1, 2}));
}

/// An unskinned part is placed at rest by its node, and so are its displacements.
TEST(MorphTargets, TurnWithTheRestPoseOfAnUnskinnedPart) {
  GltfBuilder builder = morphing_stone();
  builder.document["nodes"][0]["scale"] = {2, 3, 4};
  builder.document["nodes"][0]["translation"] = {5, 6, 7};
  const Asset asset = builder.read();
  EXPECT_EQ(asset.morph_displacements[0], (Vec3{2, 0, 0}));
  EXPECT_EQ(asset.morph_displacements[3], (Vec3{0, 3, 0}));
}

TEST(MorphTargets, MayHaveNamesThatAreNone) {
  for (const test::json& extras :
       {test::json("text"), test::json::array(), test::json{{"targetNames", 7}},
        test::json{{"targetNames", {1, 2}}}}) {
    GltfBuilder builder = morphing_stone();
    builder.document["meshes"][0]["extras"] = extras;
    const Asset asset = builder.read();
    EXPECT_EQ(asset.morph_targets[0].name, "");
  }
}

TEST(MorphTargets, MustHaveOneDisplacementForEachVertex) {
  GltfBuilder builder = morphing_stone();
  builder.accessor(2)["count"] = 2;
  EXPECT_TRUE(refused(builder.load(), {"accessor 2", "morph target 2", "2 elements for 3"}));
}

/// A few bytes must not be able to declare any number of targets.
TEST(MorphTargets, AreCountedAgainstTheSizeOfTheFile) {
  GltfBuilder builder = morphing_stone();
  for (int t = 0; t < 3000; ++t) builder.primitive()["targets"].push_back({{"POSITION", 1}});
  builder.accessor(0).erase("bufferView");
  builder.accessor(0)["count"] = 100000;
  builder.accessor(1).erase("bufferView");
  builder.accessor(1)["count"] = 100000;
  builder.accessor(2).erase("bufferView");
  builder.accessor(2)["count"] = 100000;
  EXPECT_TRUE(refused(builder.load(), {"out of proportion"}));
}

}  // namespace
}  // namespace pelt::asset
