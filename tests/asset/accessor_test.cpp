#include "asset/accessor.hpp"

#include "support/gltf_builder.hpp"

#include <limits>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::refused;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A stone whose POSITION is the builder's last accessor.
void use_last_as_position(GltfBuilder& builder) {
  builder.attribute("POSITION") = builder.document["accessors"].size() - 1;
}

std::vector<Vec3> positions(const GltfBuilder& builder) { return builder.read().rest_positions; }

template <typename T>
std::vector<Vec3> positions_stored_as(std::vector<T> values, bool normalised) {
  GltfBuilder builder = test::stone();
  builder.add_accessor(values, "VEC3", normalised);
  use_last_as_position(builder);
  return positions(builder);
}

TEST(Accessor, ReadsFloats) {
  const std::vector<Vec3> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(positions(test::stone()), expected);
}

TEST(Accessor, ReadsPlainIntegers) {
  const std::vector<Vec3> small = {{0, 1, 2}, {3, 4, 5}, {6, 7, 127}};
  EXPECT_EQ(positions_stored_as<std::int8_t>({0, 1, 2, 3, 4, 5, 6, 7, 127}, false), small);
  EXPECT_EQ(positions_stored_as<std::uint8_t>({0, 1, 2, 3, 4, 5, 6, 7, 127}, false), small);
  const std::vector<Vec3> large = {{-32768, 1, 2}, {3, 4, 5}, {6, 7, 32767}};
  EXPECT_EQ(positions_stored_as<std::int16_t>({-32768, 1, 2, 3, 4, 5, 6, 7, 32767}, false), large);
  const std::vector<Vec3> larger = {{65535, 1, 2}, {3, 4, 5}, {6, 7, 32767}};
  EXPECT_EQ(positions_stored_as<std::uint16_t>({65535, 1, 2, 3, 4, 5, 6, 7, 32767}, false), larger);
}

TEST(Accessor, ReadsNormalisedIntegers) {
  const std::vector<Vec3> bytes = {{-1, -1, 0}, {64 / 127.0f, 1, 0}, {0, 0, 0}};
  EXPECT_EQ(positions_stored_as<std::int8_t>({-128, -127, 0, 64, 127, 0, 0, 0, 0}, true), bytes);
  const std::vector<Vec3> unsigned_bytes = {{0, 1, 128 / 255.0f}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(positions_stored_as<std::uint8_t>({0, 255, 128, 0, 0, 0, 0, 0, 0}, true),
            unsigned_bytes);
  const std::vector<Vec3> shorts = {{-1, -1, 0}, {5 / 32767.0f, 1, 0}, {0, 0, 0}};
  EXPECT_EQ(positions_stored_as<std::int16_t>({-32768, -32767, 0, 5, 32767, 0, 0, 0, 0}, true),
            shorts);
  const std::vector<Vec3> unsigned_shorts = {{0, 1, 7 / 65535.0f}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(positions_stored_as<std::uint16_t>({0, 65535, 7, 0, 0, 0, 0, 0, 0}, true),
            unsigned_shorts);
}

TEST(Accessor, ReadsStridedAndOffsetElements) {
  GltfBuilder builder = test::stone();
  builder.add_view(std::vector<float>{9, 9, 0, 1, 2, 9, 9, 3, 4, 5, 9, 9, 6, 7, 8});
  builder.document["bufferViews"].back()["byteStride"] = 20;
  builder.add("accessors", {{"bufferView", 1},
                            {"byteOffset", 8},
                            {"componentType", 5126},
                            {"type", "VEC3"},
                            {"count", 3}});
  use_last_as_position(builder);
  const std::vector<Vec3> expected = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  EXPECT_EQ(positions(builder), expected);
  builder.document["accessors"].back()["byteOffset"] = 12;
  EXPECT_TRUE(refused(builder.load(), {"accessor 1", "POSITION", "reach beyond bufferView 1"}));
}

TEST(Accessor, WithoutAViewIsZeros) {
  GltfBuilder builder = test::stone();
  builder.accessor(0).erase("bufferView");
  EXPECT_EQ(positions(builder), std::vector<Vec3>(3));
}

/// Replaces elements 0 and 2 of the stone's positions.
template <typename Index>
GltfBuilder sparse_stone(std::vector<Index> elements) {
  GltfBuilder builder = test::stone();
  const std::size_t indices = builder.add_view(elements);
  const std::size_t values = builder.add_view(std::vector<float>{1, 2, 3, 4, 5, 6});
  builder.accessor(0)["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", indices}, {"componentType", test::kComponentType<Index>}}},
      {"values", {{"bufferView", values}}}};
  return builder;
}

TEST(Accessor, ReadsSparseElementsOverABase) {
  const std::vector<Vec3> expected = {{1, 2, 3}, {1, 0, 0}, {4, 5, 6}};
  EXPECT_EQ(positions(sparse_stone<std::uint8_t>({0, 2})), expected);
  EXPECT_EQ(positions(sparse_stone<std::uint16_t>({0, 2})), expected);
  EXPECT_EQ(positions(sparse_stone<std::uint32_t>({0, 2})), expected);
}

TEST(Accessor, ReadsSparseElementsOverZeros) {
  GltfBuilder builder = sparse_stone<std::uint16_t>({0, 2});
  builder.accessor(0).erase("bufferView");
  const std::vector<Vec3> expected = {{1, 2, 3}, {0, 0, 0}, {4, 5, 6}};
  EXPECT_EQ(positions(builder), expected);
}

TEST(Accessor, RefusesSparseIndicesOutOfOrderOrRange) {
  EXPECT_TRUE(refused(sparse_stone<std::uint8_t>({2, 0}).load(), {"accessor 0", "sparse index 0"}));
  EXPECT_TRUE(refused(sparse_stone<std::uint8_t>({1, 1}).load(), {"accessor 0", "sparse index 1"}));
  EXPECT_TRUE(refused(sparse_stone<std::uint8_t>({0, 3}).load(), {"accessor 0", "sparse index 3"}));
  EXPECT_TRUE(refused(sparse_stone<std::uint32_t>({0, 0xFFFFFFFF}).load(),
                      {"accessor 0", "sparse index 4294967295"}));
}

TEST(Accessor, RefusesSignedSparseIndices) {
  EXPECT_TRUE(refused(sparse_stone<std::int8_t>({0, 2}).load(),
                      {"accessor 0", "sparse indices must be unsigned"}));
}

TEST(Accessor, RefusesSparseRangesBeyondTheirViews) {
  for (const char* part : {"indices", "values"}) {
    GltfBuilder builder = sparse_stone<std::uint16_t>({0, 2});
    builder.accessor(0)["sparse"][part]["byteOffset"] = 16;
    EXPECT_TRUE(refused(builder.load(), {"accessor 0", part, "reach beyond bufferView"}));
    builder.accessor(0)["sparse"][part]["byteOffset"] = UINT64_MAX;
    EXPECT_TRUE(refused(builder.load(), {"accessor 0", part, "reach beyond bufferView"}));
  }
  GltfBuilder builder = sparse_stone<std::uint16_t>({0, 2});
  builder.accessor(0)["sparse"]["count"] = UINT64_MAX;
  EXPECT_TRUE(refused(builder.load(), {"accessor 0", "sparse", "reach beyond bufferView"}));
}

TEST(Accessor, RefusesCountsBeyondTheBytes) {
  for (const std::uint64_t count : {std::uint64_t{4}, std::uint64_t{100000}}) {
    GltfBuilder builder = test::stone();
    builder.accessor(0)["count"] = count;
    EXPECT_TRUE(refused(builder.load(), {"accessor 0", "POSITION of mesh 0 \"rock\"",
                                         std::to_string(count), "reach beyond bufferView 0"}));
  }
}

TEST(Accessor, RefusesCountsOutOfAllProportion) {
  const std::uint64_t kHuge[] = {1000000000,      std::uint64_t{1} << 32, std::uint64_t{1} << 62,
                                 UINT64_MAX / 12, UINT64_MAX / 12 + 1,    UINT64_MAX};
  for (const std::uint64_t count : kHuge) {
    for (const bool zeros : {false, true}) {
      GltfBuilder builder = test::stone();
      builder.accessor(0)["count"] = count;
      if (zeros) builder.accessor(0).erase("bufferView");
      EXPECT_TRUE(refused(builder.load(), {"accessor 0", std::to_string(count), "proportion"}));
    }
  }
}

TEST(Accessor, RefusesOffsetsBeyondTheView) {
  for (const std::uint64_t offset : {std::uint64_t{1}, std::uint64_t{37}, UINT64_MAX}) {
    GltfBuilder builder = test::stone();
    builder.accessor(0)["byteOffset"] = offset;
    EXPECT_TRUE(refused(builder.load(), {"accessor 0", "reach beyond bufferView 0"})) << offset;
  }
}

TEST(Accessor, RefusesAStrideBelowTheElement) {
  GltfBuilder builder = test::stone();
  builder.document["bufferViews"][0]["byteStride"] = 8;
  EXPECT_TRUE(refused(builder.load(), {"accessor 0", "byteStride"}));
}

TEST(Accessor, RefusesWhatIsNotFinite) {
  for (const float value : {kNan, kInfinity, -kInfinity}) {
    GltfBuilder builder = test::stone();
    builder.set_value(0, 7, value);
    EXPECT_TRUE(refused(builder.load(), {"node 0 \"stone\"", "accessor 0", "POSITION",
                                         "primitive 0", "element 2 is"}));
  }
}

TEST(Accessor, RefusesTheWrongType) {
  GltfBuilder builder = test::stone();
  builder.accessor(0)["type"] = "VEC2";
  EXPECT_TRUE(refused(builder.load(), {"accessor 0", "its type is VEC2, must be VEC3"}));
  builder = test::paper_strip();
  builder.accessor(3)["type"] = "MAT2";
  EXPECT_TRUE(refused(builder.load(), {"accessor 3", "its type is MAT2, must be VEC4"}));
}

TEST(Accessor, RefusesComponentTypesThatTheUseDoesNotAllow) {
  GltfBuilder builder = test::stone();
  builder.accessor(0)["componentType"] = 5125;
  EXPECT_TRUE(refused(builder.load(), {"accessor 0", "component type"}));
  builder = test::stone();
  builder.accessor(0)["normalized"] = true;
  EXPECT_TRUE(refused(builder.load(), {"accessor 0", "component type"}));
  builder = test::paper_strip();
  builder.accessor(4)["componentType"] = 5123;
  EXPECT_TRUE(refused(builder.load(), {"accessor 4", "inverseBindMatrices", "component type"}));
}

TEST(Accessor, RefusesWeightsThatAreIntegersButNoFractions) {
  GltfBuilder builder = test::paper_strip();
  builder.add_accessor(std::vector<std::uint8_t>(32, 64), "VEC4", false);
  builder.attribute("WEIGHTS_0") = builder.document["accessors"].size() - 1;
  EXPECT_TRUE(refused(builder.load(), {"WEIGHTS_0", "component type"}));
}

TEST(Accessor, RefusesIndicesThatAreNotUnsigned) {
  GltfBuilder builder = test::paper_strip();
  for (const int type : {5120, 5122, 5126}) {
    builder.accessor(0)["componentType"] = type;
    EXPECT_TRUE(refused(builder.load(), {"accessor 0", "indices of", "unsigned integers"}));
  }
  builder = test::paper_strip();
  builder.accessor(2)["componentType"] = 5125;
  EXPECT_TRUE(refused(builder.load(), {"accessor 2", "JOINTS_0", "at most 16 bits"}));
  builder.accessor(2)["componentType"] = 5121;
  builder.accessor(2)["normalized"] = true;
  EXPECT_TRUE(refused(builder.load(), {"accessor 2", "not normalised"}));
}

}  // namespace
}  // namespace pelt::asset
