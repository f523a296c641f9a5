#pragma once

/// Small glTF files made in memory, whole or broken on purpose.

#include <pelt/asset.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <initializer_list>

namespace pelt::test {

using nlohmann::json;

template <typename T>
constexpr int kComponentType = 0;
template <>
inline constexpr int kComponentType<std::int8_t> = 5120;
template <>
inline constexpr int kComponentType<std::uint8_t> = 5121;
template <>
inline constexpr int kComponentType<std::int16_t> = 5122;
template <>
inline constexpr int kComponentType<std::uint16_t> = 5123;
template <>
inline constexpr int kComponentType<std::uint32_t> = 5125;
template <>
inline constexpr int kComponentType<float> = 5126;

inline std::size_t component_count(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "MAT4") return 16;
  return static_cast<std::size_t>(type.back() - '0');
}

inline void append(std::vector<std::byte>& bytes, const void* data, std::size_t size) {
  const auto* first = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

inline void append_u32(std::vector<std::byte>& bytes, std::size_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  append(bytes, &number, 4);
}

/// The bytes of a .glb with these two chunks.
inline std::vector<std::byte> make_glb(std::string text, std::vector<std::byte> binary) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  std::vector<std::byte> file;
  append(file, "glTF", 4);
  append_u32(file, 2);
  append_u32(file, 12 + 8 + text.size() + 8 + binary.size());
  append_u32(file, text.size());
  append(file, "JSON", 4);
  append(file, text.data(), text.size());
  append_u32(file, binary.size());
  append(file, "BIN\0", 4);
  append(file, binary.data(), binary.size());
  return file;
}

inline std::string base64(const std::vector<std::byte>& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// A document and its one buffer. Tests change `json` as they like before they make a file of it.
class GltfBuilder {
 public:
  json document = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::byte> binary;

  /// Appends to an array of the document; returns the element's number.
  std::size_t add(const char* array, const json& element) {
    document[array].push_back(element);
    return document[array].size() - 1;
  }

  /// A view on bytes that it appends to the buffer.
  std::size_t add_view(const void* data, std::size_t size) {
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t offset = binary.size();
    append(binary, data, size);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
  }

  template <typename T>
  std::size_t add_view(const std::vector<T>& values) {
    return add_view(values.data(), values.size() * sizeof(T));
  }

  /// An accessor on values that it appends to the buffer.
  template <typename T>
  std::size_t add_accessor(const std::vector<T>& values, const std::string& type,
                           bool normalised = false) {
    const std::size_t view = add_view(values);
    return add("accessors", {{"bufferView", view},
                             {"componentType", kComponentType<T>},
                             {"normalized", normalised},
                             {"type", type},
                             {"count", values.size() / component_count(type)}});
  }

  json& accessor(std::size_t index) { return document["accessors"][index]; }
  json& primitive(std::size_t mesh = 0, std::size_t index = 0) {
    return document["meshes"][mesh]["primitives"][index];
  }
  json& attribute(const char* name) { return primitive()["attributes"][name]; }

  /// Sets the bytes of an accessor that has no gaps.
  template <typename T>
  void set_value(std::size_t accessor_index, std::size_t i, T value) {
    const json& view = document["bufferViews"][accessor(accessor_index)["bufferView"].get<int>()];
    std::memcpy(&binary[view["byteOffset"].get<std::size_t>() + i * sizeof(T)], &value, sizeof(T));
  }

  std::vector<std::byte> glb() const {
    json whole = document;
    if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", binary.size()}}};
    return make_glb(whole.dump(), binary);
  }

  /// The .gltf that has its buffer under this uri; "" puts the bytes into the text.
  std::vector<std::byte> gltf(std::string uri = "") const {
    json whole = document;
    if (uri.empty()) uri = "data:application/octet-stream;base64," + base64(binary);
    whole["buffers"] = {{{"byteLength", binary.size()}, {"uri", uri}}};
    const std::string text = whole.dump();
    std::vector<std::byte> file;
    append(file, text.data(), text.size());
    return file;
  }

  Result<asset::Asset> load(const asset::GltfOptions& options = {}) const {
    return asset::load_gltf(glb(), {}, options);
  }
};

/// Passes when the result is an error whose message has all the words.
inline ::testing::AssertionResult refused(const Result<asset::Asset>& result,
                                          std::initializer_list<std::string_view> words) {
  if (result) return ::testing::AssertionFailure() << "was not refused";
  const std::string& message = result.error().message;
  for (const std::string_view word : words) {
    if (message.find(word) != message.npos) continue;
    return ::testing::AssertionFailure() << "no \"" << word << "\" in: " << message;
  }
  return ::testing::AssertionSuccess() << message;
}

/// A skinned strip of paper: 8 vertices at x 0 and 1, y 0 to 3, 6 triangles; two joints, at y 0 and
/// y 1.5; a clip "bend". Nodes: 0 "paper", 1 "lower", 2 "upper". Accessors: 0 indices, 1 POSITION,
/// 2 JOINTS_0, 3 WEIGHTS_0, 4 inverse bind matrices, 5 times, 6 rotations.
inline GltfBuilder paper_strip() {
  GltfBuilder builder;
  std::vector<std::uint16_t> indices;
  for (std::uint16_t row = 0; row < 3; ++row) {
    const auto v = static_cast<std::uint16_t>(2 * row);
    for (const int corner : {0, 1, 2, 2, 1, 3}) {
      indices.push_back(static_cast<std::uint16_t>(v + corner));
    }
  }
  std::vector<float> positions, weights;
  std::vector<std::uint8_t> joints;
  for (int v = 0; v < 8; ++v) {
    const float y = static_cast<float>(v / 2);
    positions.insert(positions.end(), {static_cast<float>(v % 2), y, 0});
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1 - y / 4, y / 4, 0, 0});
  }
  const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,     0, 1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.5f, 0, 1};
  builder.add_accessor(indices, "SCALAR");
  builder.add_accessor(positions, "VEC3");
  builder.add_accessor(joints, "VEC4");
  builder.add_accessor(weights, "VEC4");
  builder.add_accessor(matrices, "MAT4");
  builder.add_accessor(std::vector<float>{0, 1}, "SCALAR");
  builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0.6f, 0.8f}, "VEC4");
  const json attributes = {{"POSITION", 1}, {"JOINTS_0", 2}, {"WEIGHTS_0", 3}};
  const json primitive = {{"attributes", attributes}, {"indices", 0}};
  builder.add("meshes", {{"name", "sheet"}, {"primitives", {primitive}}});
  builder.add("nodes", {{"name", "paper"}, {"mesh", 0}, {"skin", 0}});
  builder.add("nodes", {{"name", "lower"}, {"children", {2}}});
  builder.add("nodes", {{"name", "upper"}, {"translation", {0, 1.5, 0}}});
  builder.add("skins", {{"name", "rig"}, {"joints", {1, 2}}, {"inverseBindMatrices", 4}});
  builder.add("scenes", {{"nodes", {0, 1}}});
  const json channel = {{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}};
  const json sampler = {{"input", 5}, {"output", 6}};
  builder.add("animations", {{"name", "bend"}, {"channels", {channel}}, {"samplers", {sampler}}});
  return builder;
}

/// One triangle without a skin. Accessors: 0 POSITION. Node 0 "stone".
inline GltfBuilder stone() {
  GltfBuilder builder;
  builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  builder.add("meshes", {{"name", "rock"}, {"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  builder.add("nodes", {{"name", "stone"}, {"mesh", 0}});
  builder.add("scenes", {{"nodes", {0}}});
  return builder;
}

}  // namespace pelt::test
