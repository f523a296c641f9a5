#pragma once

/// Builds a .glb file: JSON and binary chunk grow together.

#include <pelt/mesh.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace pelt::scenes {

/// Returns a .glb file with this JSON text and binary chunk. Precondition: less than 4 GB.
std::vector<std::byte> make_glb_file(std::string_view json, std::span<const std::byte> binary);

class GlbBuilder {
 public:
  /// Starts with "asset" and one scene without nodes.
  GlbBuilder();

  nlohmann::ordered_json json;

  /// Adds positions with the bounds that glTF requires. Precondition, as for all arrays: not empty.
  std::size_t add_positions(std::span<const Vec3> positions);
  std::size_t add_vectors(std::span<const Vec3> vectors);
  std::size_t add_indices(std::span<const Triangle> triangles);

  /// Adds an accessor of `count` elements. Like all of these, returns the accessor's number.
  std::size_t add_floats(std::span<const float> floats, std::size_t count, const char* type);
  std::size_t add_shorts(std::span<const std::uint16_t> shorts, std::size_t count,
                         const char* type);

  /// Adds times of keys with their bounds.
  std::size_t add_times(std::span<const float> times);

  /// Adds `count` vectors that are zero except at these ascending indices.
  std::size_t add_sparse(std::size_t count, std::span<const std::uint32_t> indices,
                         std::span<const Vec3> vectors);

  /// Returns the whole file.
  std::vector<std::byte> file();

 private:
  std::size_t add_view(std::span<const std::byte> bytes);
  std::size_t add_view(std::span<const std::byte> bytes, int target);
  std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type);

  std::vector<std::byte> binary_;  // every view is a multiple of 4 bytes, so all stay aligned
};

}  // namespace pelt::scenes
