#include "scenes/glb_builder.hpp"

#include <pelt/version.hpp>

#include "base/assert.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace pelt::scenes {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian, and so are we");

constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;  // componentType
constexpr int kArrayBuffer = 34962, kElementArray = 34963;                // bufferView.target

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

void add_bounds(std::span<const Vec3> positions, ordered_json& accessor) {
  Vec3 least = positions[0], most = positions[0];
  for (const Vec3& p : positions) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  accessor["min"] = {least.x, least.y, least.z};
  accessor["max"] = {most.x, most.y, most.z};
}

}  // namespace

std::vector<std::byte> make_glb_file(std::string_view json, std::span<const std::byte> binary) {
  constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJson = 0x4E4F534A, kBin = 0x004E4942;
  std::vector<std::byte> chunks;
  append_chunk(chunks, std::as_bytes(std::span(json.data(), json.size())), kJson, ' ');
  append_chunk(chunks, binary, kBin, '\0');
  std::vector<std::byte> file;
  append_u32(file, kMagic);
  append_u32(file, kVersion);
  append_u32(file, 12 + chunks.size());
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

GlbBuilder::GlbBuilder() {
  json["asset"] = {{"version", "2.0"}, {"generator", "pelt " PELT_VERSION}};
  json["scene"] = 0;
}

std::size_t GlbBuilder::add_positions(std::span<const Vec3> positions) {
  const std::size_t accessor = add_vectors(positions);
  add_bounds(positions, json["accessors"][accessor]);
  return accessor;
}

std::size_t GlbBuilder::add_vectors(std::span<const Vec3> vectors) {
  const std::size_t view = add_view(std::as_bytes(vectors), kArrayBuffer);
  return add_accessor(view, kFloat, vectors.size(), "VEC3");
}

std::size_t GlbBuilder::add_indices(std::span<const Triangle> triangles) {
  const std::size_t view = add_view(std::as_bytes(triangles), kElementArray);
  return add_accessor(view, kUnsignedInt, 3 * triangles.size(), "SCALAR");
}

std::size_t GlbBuilder::add_floats(std::span<const float> floats, std::size_t count,
                                   const char* type) {
  return add_accessor(add_view(std::as_bytes(floats)), kFloat, count, type);
}

std::size_t GlbBuilder::add_shorts(std::span<const std::uint16_t> shorts, std::size_t count,
                                   const char* type) {
  return add_accessor(add_view(std::as_bytes(shorts)), kUnsignedShort, count, type);
}

std::size_t GlbBuilder::add_times(std::span<const float> times) {
  const std::size_t accessor = add_floats(times, times.size(), "SCALAR");
  json["accessors"][accessor]["min"][0] = times.front();
  json["accessors"][accessor]["max"][0] = times.back();
  return accessor;
}

std::size_t GlbBuilder::add_sparse(std::size_t count, std::span<const std::uint32_t> indices,
                                   std::span<const Vec3> vectors) {
  PELT_ASSERT(!indices.empty() && indices.size() == vectors.size());
  const std::size_t index_view = add_view(std::as_bytes(indices));
  const std::size_t value_view = add_view(std::as_bytes(vectors));
  ordered_json accessor = {{"componentType", kFloat}, {"count", count}, {"type", "VEC3"}};
  std::vector<Vec3> all(vectors.begin(), vectors.end());
  if (indices.size() < count) all.push_back({});
  add_bounds(all, accessor);
  accessor["sparse"] = {{"count", indices.size()},
                        {"indices", {{"bufferView", index_view}, {"componentType", kUnsignedInt}}},
                        {"values", {{"bufferView", value_view}}}};
  json["accessors"].push_back(std::move(accessor));
  return json["accessors"].size() - 1;
}

std::vector<std::byte> GlbBuilder::file() {
  json["buffers"][0]["byteLength"] = binary_.size();
  const std::string text = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return make_glb_file(text, binary_);
}

std::size_t GlbBuilder::add_view(std::span<const std::byte> bytes) {
  PELT_ASSERT(bytes.size() % 4 == 0);
  json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}});
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  return json["bufferViews"].size() - 1;
}

std::size_t GlbBuilder::add_view(std::span<const std::byte> bytes, int target) {
  const std::size_t view = add_view(bytes);
  json["bufferViews"][view]["target"] = target;
  return view;
}

std::size_t GlbBuilder::add_accessor(std::size_t view, int component, std::size_t count,
                                     const char* type) {
  json["accessors"].push_back(
      {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return json["accessors"].size() - 1;
}

}  // namespace pelt::scenes
