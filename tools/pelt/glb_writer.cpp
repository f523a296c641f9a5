#include "tools/pelt/glb_writer.hpp"

#include <pelt/version.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstring>

namespace pelt::tools {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian, and so are we");

constexpr int kFloat = 5126, kUnsignedInt = 5125;           // componentType
constexpr int kArrayBuffer = 34962, kElementArray = 34963;  // bufferView.target

/// The JSON and binary chunks while they grow together.
class Builder {
 public:
  ordered_json json;

  std::size_t add_vectors(std::span<const Vec3> vectors) {
    const std::size_t view = add_view(std::as_bytes(vectors), kArrayBuffer);
    return add_accessor(view, kFloat, vectors.size(), "VEC3");
  }

  std::size_t add_indices(std::span<const Triangle> triangles) {
    const std::size_t view = add_view(std::as_bytes(triangles), kElementArray);
    return add_accessor(view, kUnsignedInt, 3 * triangles.size(), "SCALAR");
  }

  const std::vector<std::byte>& binary() const { return binary_; }

 private:
  std::size_t add_view(std::span<const std::byte> bytes, int target) {
    json["bufferViews"].push_back({{"buffer", 0},
                                   {"byteOffset", binary_.size()},
                                   {"byteLength", bytes.size()},
                                   {"target", target}});
    binary_.insert(binary_.end(), bytes.begin(), bytes.end());
    return json["bufferViews"].size() - 1;
  }

  std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type) {
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return json["accessors"].size() - 1;
  }

  std::vector<std::byte> binary_;  // every view is a multiple of 4 bytes, so all stay aligned
};

/// glTF requires the bounds of positions.
void add_bounds(std::span<const Vec3> positions, ordered_json& accessor) {
  Vec3 least = positions[0], most = positions[0];
  for (const Vec3& p : positions) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  accessor["min"] = {least.x, least.y, least.z};
  accessor["max"] = {most.x, most.y, most.z};
}

void add_mesh(const GlbMesh& mesh, Builder& builder) {
  ordered_json attributes;
  const std::size_t positions = builder.add_vectors(mesh.positions);
  attributes["POSITION"] = positions;
  add_bounds(mesh.positions, builder.json["accessors"][positions]);
  if (!mesh.normals.empty()) attributes["NORMAL"] = builder.add_vectors(mesh.normals);
  ordered_json primitives = ordered_json::array();
  for (const GlbPrimitive& primitive : mesh.primitives) {
    primitives.push_back({{"attributes", attributes},
                          {"indices", builder.add_indices(primitive.triangles)},
                          {"material", primitive.material}});
  }
  ordered_json& json = builder.json;
  const std::size_t number = json["meshes"].size();
  json["meshes"].push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
  json["nodes"].push_back({{"name", mesh.name}, {"mesh", number}});
  json["scenes"][0]["nodes"].push_back(number);
}

ordered_json material_json(const GlbMaterial& material) {
  const std::array<float, 3>& c = material.base_colour;
  return {{"name", material.name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {c[0], c[1], c[2], 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.6}}},
          {"emissiveFactor", material.emissive},
          {"doubleSided", true}};
}

void append_u32(std::vector<std::byte>& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof word);
  std::memcpy(bytes.data() + at, &word, sizeof word);
}

void append_chunk(std::vector<std::byte>& file, std::span<const std::byte> data, std::uint32_t type,
                  char padding) {
  const std::size_t padded = (data.size() + 3) / 4 * 4;
  append_u32(file, padded);
  append_u32(file, type);
  file.insert(file.end(), data.begin(), data.end());
  file.resize(file.size() + padded - data.size(), static_cast<std::byte>(padding));
}

}  // namespace

std::vector<std::byte> make_glb(std::span<const GlbMesh> meshes,
                                std::span<const GlbMaterial> materials) {
  Builder builder;
  builder.json["asset"] = {{"version", "2.0"}, {"generator", "pelt " PELT_VERSION}};
  builder.json["scene"] = 0;
  for (const GlbMaterial& material : materials) {
    builder.json["materials"].push_back(material_json(material));
  }
  for (const GlbMesh& mesh : meshes) add_mesh(mesh, builder);
  builder.json["buffers"] = {{{"byteLength", builder.binary().size()}}};

  const std::string text =
      builder.json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJson = 0x4E4F534A, kBin = 0x004E4942;
  std::vector<std::byte> chunks;
  append_chunk(chunks, std::as_bytes(std::span(text)), kJson, ' ');
  append_chunk(chunks, builder.binary(), kBin, '\0');
  std::vector<std::byte> file;
  append_u32(file, kMagic);
  append_u32(file, kVersion);
  append_u32(file, 12 + chunks.size());
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

}  // namespace pelt::tools
