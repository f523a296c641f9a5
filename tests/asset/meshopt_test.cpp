#include "asset/meshopt.hpp"

#include "support/gltf_builder.hpp"
#include "support/random.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

constexpr const char* kExtension = "EXT_meshopt_compression";

std::vector<std::byte> bytes_of(const GltfBuilder& builder, std::size_t view) {
  const json& range = builder.document["bufferViews"][view];
  const auto first = builder.binary.begin() + range["byteOffset"].get<std::ptrdiff_t>();
  return {first, first + range["byteLength"].get<std::ptrdiff_t>()};
}

std::vector<unsigned char> encode_attributes(const std::vector<std::byte>& bytes,
                                             std::size_t stride) {
  const std::size_t count = bytes.size() / stride;
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), bytes.data(), count, stride));
  return out;
}

std::vector<unsigned char> encode_indices(const std::vector<std::byte>& bytes, bool triangles) {
  std::vector<std::uint32_t> indices(bytes.size() / 2);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint16_t index;
    std::memcpy(&index, &bytes[2 * i], 2);
    indices[i] = index;
  }
  std::vector<unsigned char> out(4096);
  out.resize(
      triangles
          ? meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size())
          : meshopt_encodeIndexSequence(out.data(), out.size(), indices.data(), indices.size()));
  return out;
}

/// Moves the compressed bytes of a view into the buffer and sets the view to a fallback.
void compress_view(GltfBuilder& builder, std::size_t view, const std::vector<unsigned char>& packed,
                   std::size_t stride, const char* mode, const char* filter = "NONE") {
  const std::size_t offset = builder.binary.size();
  test::append(builder.binary, packed.data(), packed.size());
  json& target = builder.document["bufferViews"][view];
  target["buffer"] = 1;
  target["extensions"][kExtension] = {{"buffer", 0},
                                      {"byteOffset", offset},
                                      {"byteLength", packed.size()},
                                      {"byteStride", stride},
                                      {"count", target["byteLength"].get<std::size_t>() / stride},
                                      {"mode", mode},
                                      {"filter", filter}};
  const json fallback = {{"byteLength", builder.binary.size()},
                         {"extensions", {{kExtension, {{"fallback", true}}}}}};
  builder.document["buffers"] = json::array({{{"byteLength", builder.binary.size()}}, fallback});
}

json& extension(GltfBuilder& builder, std::size_t view) {
  return builder.document["bufferViews"][view]["extensions"][kExtension];
}

/// The strip with its positions, joints, weights and indices compressed.
GltfBuilder compressed_strip(bool triangles) {
  GltfBuilder builder = test::paper_strip();
  compress_view(builder, 0, encode_indices(bytes_of(builder, 0), triangles), 2,
                triangles ? "TRIANGLES" : "INDICES");
  compress_view(builder, 1, encode_attributes(bytes_of(builder, 1), 12), 12, "ATTRIBUTES");
  compress_view(builder, 2, encode_attributes(bytes_of(builder, 2), 4), 4, "ATTRIBUTES");
  compress_view(builder, 3, encode_attributes(bytes_of(builder, 3), 16), 16, "ATTRIBUTES");
  builder.document["extensionsRequired"] = {kExtension};
  return builder;
}

/// Rotates every triangle so that its smallest index comes first, because the codec may rotate
/// them.
std::vector<Triangle> turned(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) {
    while (triangle[0] > triangle[1] || triangle[0] > triangle[2]) {
      triangle = {triangle[1], triangle[2], triangle[0]};
    }
  }
  return triangles;
}

TEST(Meshopt, DecodesAttributesAndIndices) {
  const Result<Asset> plain = test::paper_strip().load();
  for (const bool triangles : {true, false}) {
    const Asset asset = compressed_strip(triangles).read();
    EXPECT_EQ(asset.rest_positions, plain->rest_positions);
    EXPECT_EQ(asset.joint_indices, plain->joint_indices);
    EXPECT_EQ(asset.weights, plain->weights);
    EXPECT_EQ(turned(asset.triangles), turned(plain->triangles));
  }
}

TEST(Meshopt, DecodesTheExponentialFilter) {
  GltfBuilder builder = test::paper_strip();
  std::vector<float> positions(24);
  const std::vector<std::byte> plain = bytes_of(builder, 1);
  std::memcpy(positions.data(), plain.data(), plain.size());
  std::vector<std::byte> filtered(plain.size());
  meshopt_encodeFilterExp(filtered.data(), 8, 12, 24, positions.data());
  compress_view(builder, 1, encode_attributes(filtered, 12), 12, "ATTRIBUTES", "EXPONENTIAL");
  const Asset asset = builder.read();
  EXPECT_EQ(asset.rest_positions, test::paper_strip().load()->rest_positions);
}

TEST(Meshopt, DecodesTheQuaternionFilter) {
  GltfBuilder builder = test::paper_strip();
  const float keys[] = {0, 0, 0, 1, 0, 0, 0.6f, 0.8f};
  std::vector<std::byte> filtered(16);
  meshopt_encodeFilterQuat(filtered.data(), 2, 8, 16, keys);
  const std::size_t accessor = builder.add_accessor(std::vector<std::int16_t>(8), "VEC4", true);
  compress_view(builder, accessor, encode_attributes(filtered, 8), 8, "ATTRIBUTES", "QUATERNION");
  builder.document["animations"][0]["samplers"][0]["output"] = accessor;
  const Asset asset = builder.read();
  const std::vector<float>& values = asset.clips[0].channels[0].values;
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(values[i], keys[i], 1e-4f) << i;
}

TEST(Meshopt, QuaternionsAgreeWithTheLibrary) {
  constexpr std::size_t kCount = 10000;
  test::Random random(31);
  std::vector<std::int16_t> own(4 * kCount);
  std::vector<float> rotation(4 * kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    double squared = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      rotation[4 * i + k] = random.uniformf(-1, 1);
      squared += double{rotation[4 * i + k]} * rotation[4 * i + k];
    }
    for (std::size_t k = 0; k < 4; ++k) {
      rotation[4 * i + k] = static_cast<float>(rotation[4 * i + k] / std::sqrt(squared));
    }
  }
  meshopt_encodeFilterQuat(own.data(), kCount, 8, 12, rotation.data());
  std::vector<std::int16_t> theirs = own;
  decode_quaternion_filter(std::as_writable_bytes(std::span(own)));
  meshopt_decodeFilterQuat(theirs.data(), kCount, 8);
  for (std::size_t i = 0; i < own.size(); ++i) ASSERT_LE(std::abs(own[i] - theirs[i]), 1) << i;
}

/// Also bytes that no encoder writes: a scale that is zero or negative, and components beyond it.
TEST(Meshopt, QuaternionFilterAcceptsAnyBytes) {
  test::Random random(32);
  std::vector<std::int16_t> before(40000);
  for (std::int16_t& value : before) value = static_cast<std::int16_t>(random.bits());
  std::vector<std::int16_t> after = before;
  decode_quaternion_filter(std::as_writable_bytes(std::span(after)));
  int beyond_scale = 0;
  for (std::size_t i = 0; i < before.size(); i += 4) {
    const int left_out = before[i + 3] & 3;
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const double value = before[i + k] * std::sqrt(0.5) / (before[i + 3] | 3);
      squared += value * value;
      EXPECT_NEAR(after[i + (left_out + 1 + k) % 4], 32767 * std::clamp(value, -1.0, 1.0), 0.51);
    }
    beyond_scale += squared > 1;
    EXPECT_NEAR(after[i + left_out], 32767 * std::sqrt(std::max(0.0, 1 - squared)), 0.51);
  }
  EXPECT_GT(beyond_scale, 1000);
  EXPECT_LT(beyond_scale, 9900);
}

TEST(Meshopt, DecodesTheOctahedralFilter) {
  // Unit vectors in four bytes each, read as positions.
  GltfBuilder builder = test::paper_strip();
  const float normals[] = {0, 0, 1, 0, 1, 0, 0, 0};
  std::vector<std::byte> filtered(32);
  for (std::size_t i = 0; i < 8; ++i) {
    meshopt_encodeFilterOct(&filtered[4 * i], 1, 4, 8, normals + 4 * (i % 2));
  }
  const std::size_t view = builder.add_view(std::vector<std::int8_t>(32));
  builder.document["bufferViews"][view]["byteStride"] = 4;
  compress_view(builder, view, encode_attributes(filtered, 4), 4, "ATTRIBUTES", "OCTAHEDRAL");
  builder.attribute("POSITION") = builder.add("accessors", {{"bufferView", view},
                                                            {"componentType", 5120},
                                                            {"normalized", true},
                                                            {"type", "VEC3"},
                                                            {"count", 8}});
  const Asset asset = builder.read();
  EXPECT_EQ(asset.rest_positions[0], (Vec3{0, 0, 1}));
  EXPECT_EQ(asset.rest_positions[1], (Vec3{1, 0, 0}));
}

TEST(Meshopt, RefusesAFallbackThatIsReadAsIfItHadBytes) {
  GltfBuilder builder = compressed_strip(true);
  builder.document["bufferViews"][3].erase("extensions");
  EXPECT_TRUE(refused(builder.load(), {"accessor 3", "WEIGHTS_0", "buffer 1", "fallback"}));
}

TEST(Meshopt, RefusesBrokenRules) {
  struct {
    std::size_t view;
    const char* key;
    json value;
    const char* words;
  } const kCases[] = {{1, "byteStride", 0, "byteStride of ATTRIBUTES"},
                      {1, "byteStride", 6, "byteStride of ATTRIBUTES"},
                      {1, "byteStride", 260, "byteStride of ATTRIBUTES"},
                      {0, "byteStride", 3, "byteStride of indices"},
                      {0, "byteStride", 12, "byteStride of indices"},
                      {0, "count", 17, "multiple of 3"},
                      {0, "filter", "EXPONENTIAL", "indices have no filter"},
                      {1, "filter", "OCTAHEDRAL", "OCTAHEDRAL must be 4 or 8"},
                      {1, "filter", "QUATERNION", "QUATERNION must be 8"},
                      {1, "count", 7, "byteLength is not count * byteStride"},
                      {1, "count", UINT64_MAX, "cannot hold"},
                      {1, "count", 1000000, "cannot hold"},
                      {0, "count", 3000000, "cannot hold"},
                      {1, "byteLength", 5, "damaged"},
                      {1, "byteOffset", UINT64_MAX, "reach beyond"},
                      {1, "byteLength", UINT64_MAX, "reach beyond"},
                      {1, "mode", "TRIANGLES", "byteStride of indices"}};
  for (const auto& c : kCases) {
    GltfBuilder builder = compressed_strip(true);
    extension(builder, c.view)[c.key] = c.value;
    EXPECT_TRUE(refused(builder.load(), {"bufferView " + std::to_string(c.view), c.words}))
        << c.key << " " << c.value;
  }
}

TEST(Meshopt, RefusesUnknownModesAndFilters) {
  for (const char* key : {"mode", "filter"}) {
    GltfBuilder builder = compressed_strip(true);
    extension(builder, 1)[key] = "FANCY";
    EXPECT_TRUE(refused(builder.load(), {"bufferViews[1]", key, "\"FANCY\""}));
  }
  GltfBuilder builder = compressed_strip(true);
  extension(builder, 1).erase("mode");
  EXPECT_TRUE(refused(builder.load(), {"mode: is missing"}));
}

TEST(Meshopt, BoundsAreValidForTheMostCompressibleBytes) {
  for (const std::size_t stride : {std::size_t{4}, std::size_t{32}, std::size_t{256}}) {
    const std::size_t count = 100000;
    const std::vector<unsigned char> packed =
        encode_attributes(std::vector<std::byte>(count * stride), stride);
    GltfMeshopt meshopt;
    meshopt.length = packed.size();
    meshopt.stride = stride;
    meshopt.count = count;
    Budget budget;
    budget.grant(1 << 20);
    const Result<std::vector<std::byte>> bytes =
        decode_meshopt(meshopt, std::as_bytes(std::span(packed)), budget, "view");
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_EQ(bytes->size(), count * stride);
  }
}

TEST(MeshQuantization, PlaysNoRoleForTheReader) {
  // Positions in 16-bit units; the inverse bind matrices undo this, as in gltfpack.
  GltfBuilder builder = test::paper_strip();
  std::vector<std::uint16_t> positions;
  for (std::uint16_t v = 0; v < 8; ++v) {
    const auto y = static_cast<std::uint16_t>(v / 2 * 1000);
    positions.insert(positions.end(), {static_cast<std::uint16_t>(v % 2 * 1000), y, 0, 0});
  }
  const std::size_t view = builder.add_view(positions);
  builder.document["bufferViews"][view]["byteStride"] = 8;
  builder.attribute("POSITION") = builder.add(
      "accessors", {{"bufferView", view}, {"componentType", 5123}, {"type", "VEC3"}, {"count", 8}});
  builder.document["extensionsRequired"] = {"KHR_mesh_quantization"};
  for (const std::size_t element : {0, 5, 10, 16, 21, 26}) {
    builder.set_value<float>(4, element, 0.001f);
  }
  const Asset asset = builder.read();
  EXPECT_EQ(asset.rest_positions[7], (Vec3{1000, 3000, 0}));
  EXPECT_EQ(asset.joints[1].inverse_bind.m[0], 0.001f);
}

}  // namespace
}  // namespace pelt::asset
