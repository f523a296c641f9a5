#pragma once

/// Reads a .glb file with as little code as possible.

#include <pelt/mesh.hpp>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace pelt::test {

class GlbFile {
 public:
  explicit GlbFile(std::string bytes) : bytes_(std::move(bytes)) {
    const std::uint32_t json_size = word(12);
    document = nlohmann::json::parse(bytes_.substr(20, json_size));
    binary_begin_ = 28 + json_size;
  }

  nlohmann::json document;

  std::vector<Vec3> positions(std::size_t mesh) const {
    return read<Vec3>(primitive(mesh)["attributes"]["POSITION"], 1);
  }
  std::vector<Triangle> triangles(std::size_t mesh) const {
    return read<Triangle>(primitive(mesh)["indices"], 3);
  }

  const nlohmann::json& primitive(std::size_t mesh) const {
    EXPECT_EQ(document["meshes"][mesh]["primitives"].size(), 1u);
    return document["meshes"][mesh]["primitives"][0];
  }

  std::uint32_t word(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return value;
  }

  std::size_t size() const { return bytes_.size(); }

 private:
  template <typename T>
  std::vector<T> read(std::size_t accessor, std::size_t numbers_each) const {
    const nlohmann::json& a = document["accessors"][accessor];
    const nlohmann::json& view = document["bufferViews"][a["bufferView"].get<std::size_t>()];
    std::vector<T> values(a["count"].get<std::size_t>() / numbers_each);
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), values.size() * sizeof(T));
    const std::size_t begin = binary_begin_ + view["byteOffset"].get<std::size_t>();
    std::memcpy(values.data(), bytes_.data() + begin, values.size() * sizeof(T));
    return values;
  }

  std::string bytes_;
  std::size_t binary_begin_ = 0;
};

/// Bitwise equality: unlike ==, distinguishes 0 and -0.
inline bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

}  // namespace pelt::test
