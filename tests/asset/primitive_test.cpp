#include "asset/primitive.hpp"

#include "support/gltf_builder.hpp"

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

using Triangles = std::vector<Triangle>;

/// Five points without indices, drawn in a mode of the format.
GltfBuilder five_points(int mode) {
  GltfBuilder builder = test::stone();
  builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3");
  builder.attribute("POSITION") = 1;
  builder.primitive()["mode"] = mode;
  return builder;
}

Triangles triangles(const GltfBuilder& builder) {
  const Result<Asset> asset = builder.load();
  EXPECT_TRUE(asset) << asset.error().message;
  return asset ? asset->triangles : Triangles{};
}

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
    const Result<Asset> asset = builder.load();
    ASSERT_TRUE(asset) << asset.error().message;
    EXPECT_EQ(asset->triangles.size(), 1u);
    ASSERT_EQ(asset->warnings.size(), 1u);
    EXPECT_EQ(asset->warnings[0],
              "mesh 0 \"rock\", primitive 1 is passed over: it has points or lines");
  }
}

TEST(Primitive, PassesOverOneWithoutPositions) {
  GltfBuilder builder = test::stone();
  builder.document["meshes"][0]["primitives"].push_back({{"attributes", json::object()}});
  const Result<Asset> asset = builder.load();
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_EQ(asset->warnings[0], "mesh 0 \"rock\", primitive 1 is passed over: it has no POSITION");
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
  EXPECT_TRUE(
      refused(builder.load(), {"node 0 \"stone\"", "mesh 0 \"rock\"", "primitive 0", "5 corners"}));
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
  const Result<Asset> asset = test::paper_strip().load();
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_EQ(asset->influences_per_vertex, 2u);
  EXPECT_EQ(asset->weights, (std::vector<float>{1, 0, 1, 0, 0.75f, 0.25f, 0.75f, 0.25f, 0.5f, 0.5f,
                                                0.5f, 0.5f, 0.25f, 0.75f, 0.25f, 0.75f}));
  EXPECT_EQ(asset->joint_indices,
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
  const Result<Asset> asset = builder.load();
  ASSERT_TRUE(asset) << asset.error().message;
  ASSERT_EQ(asset->influences_per_vertex, 6u);
  const std::vector<float> last(asset->weights.end() - 6, asset->weights.end());
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

TEST(MorphTargets, StandAtTheDefaultWeightsOfTheMesh) {
  GltfBuilder builder = morphing_stone();
  EXPECT_EQ(builder.load()->rest_positions[0], (Vec3{0, 0, 0}));
  builder.document["meshes"][0]["weights"] = {0.5, 7, 2};
  const Result<Asset> asset = builder.load();
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_EQ(asset->rest_positions, (std::vector<Vec3>{{0.5f, 2, 0}, {1.5f, 2, 0}, {0.5f, 3, 0}}));
  ASSERT_EQ(asset->warnings.size(), 1u);
  EXPECT_EQ(asset->warnings[0],
            "mesh 0 \"rock\": its 3 morph targets are not animated, they stand at their default "
            "weights");
}

TEST(MorphTargets, StandAtTheWeightsOfTheNodeWhereItHasSome) {
  GltfBuilder builder = morphing_stone();
  builder.document["meshes"][0]["weights"] = {0.5, 0, 2};
  builder.document["nodes"][0]["weights"] = {-1};
  EXPECT_EQ(builder.load()->rest_positions[1], (Vec3{0, 0, 0}));
}

TEST(MorphTargets, MustHaveOneDeltaForEachVertex) {
  GltfBuilder builder = morphing_stone();
  builder.document["meshes"][0]["weights"] = {0, 0, 1};
  builder.accessor(2)["count"] = 2;
  EXPECT_TRUE(refused(builder.load(), {"accessor 2", "morph target 2", "2 elements for 3"}));
}

TEST(MorphTargets, MayNotMoveAVertexToInfinity) {
  GltfBuilder builder = morphing_stone();
  builder.document["meshes"][0]["weights"] = {3e38};
  builder.set_value<float>(1, 3, 3);
  EXPECT_TRUE(refused(builder.load(), {"accessor 1", "morph target 0", "vertex 1", "infinity"}));
}

}  // namespace
}  // namespace pelt::asset
