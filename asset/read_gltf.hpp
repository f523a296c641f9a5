#pragma once

#include <pelt/asset.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace pelt::asset {

struct ReadGltf {
  Asset asset;
  std::vector<std::uint32_t> views;  ///< buffer views that meshes and clips use, ascending
};

/// Like `load_gltf`, and also returns the views that it has read.
Result<ReadGltf> read_gltf(std::span<const std::byte> file, const std::filesystem::path& folder,
                           const GltfOptions& options);

}  // namespace pelt::asset
