#pragma once

/// Builds small glTF files in memory, valid or deliberately broken.

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

std::size_t component_count(const std::string& type);

void append(std::vector<std::byte>& bytes, const void* data, std::size_t size);
void append_u32(std::vector<std::byte>& bytes, std::size_t value);

/// The bytes of a .glb file with these two chunks.
std::vector<std::byte> make_glb(std::string text, std::vector<std::byte> binary);

/// A document and its single buffer. Tests may change `document` before they make a file.
class GltfBuilder {
 public:
  json document = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::byte> binary;

  /// Appends to an array of the document. Returns the element's index.
  std::size_t add(const char* array, const json& element);

  /// Appends bytes to the buffer and adds a view of them.
  std::size_t add_view(const void* data, std::size_t size);

  template <typename T>
  std::size_t add_view(const std::vector<T>& values) {
    return add_view(values.data(), values.size() * sizeof(T));
  }

  /// Appends values to the buffer and adds an accessor to them.
  template <typename T>
  std::size_t add_accessor(const std::vector<T>& values, const std::string& type,
                           bool normalised = false) {
    const std::size_t view = add_view(values);
    return add_accessor(view, kComponentType<T>, type, values.size() / component_count(type),
                        normalised);
  }

  json& accessor(std::size_t index);
  json& primitive(std::size_t mesh = 0, std::size_t index = 0);
  json& attribute(const char* name);

  /// Sets a number of an accessor without gaps.
  template <typename T>
  void set_value(std::size_t accessor, std::size_t i, T value) {
    std::memcpy(&binary[offset_of(accessor) + i * sizeof(T)], &value, sizeof(T));
  }

  std::vector<std::byte> glb() const;

  /// The .gltf file with its buffer at this URI; "" embeds the buffer in the text.
  std::vector<std::byte> gltf(std::string uri = "") const;

  Result<asset::Asset> load(const asset::GltfOptions& options = {}) const;

  /// The same for a sound file: the test fails by an exception if it is refused.
  asset::Asset read(const asset::GltfOptions& options = {}) const;

 private:
  std::size_t add_accessor(std::size_t view, int component_type, const std::string& type,
                           std::size_t count, bool normalised);
  std::size_t offset_of(std::size_t accessor);
};

/// Succeeds if the result is an error whose message contains all the words and, if the file is at
/// fault, says how to fix the file: by exporting something else.
::testing::AssertionResult refused(const Result<asset::Asset>& result,
                                   std::initializer_list<std::string_view> words);

/// A skinned strip of paper: 8 vertices at x 0 and 1, y 0 to 3, 6 triangles; two joints, at y 0 and
/// y 1.5; a clip "bend". Nodes: 0 "paper", 1 "lower", 2 "upper". Accessors: 0 indices, 1 POSITION,
/// 2 JOINTS_0, 3 WEIGHTS_0, 4 inverse bind matrices, 5 times, 6 rotations.
GltfBuilder paper_strip();

/// One triangle without a skin. Accessors: 0 POSITION. Node 0 "stone".
GltfBuilder stone();

}  // namespace pelt::test
