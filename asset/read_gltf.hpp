#pragma once

#include <pelt/asset.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace pelt::asset {

struct ReadGltf {
  Asset asset;
  std::vector<std::filesystem::path> files;  ///< external buffers that meshes and clips use
};

/// Like `load_gltf`, and also returns the other files that it has read.
Result<ReadGltf> read_gltf(std::span<const std::byte> file, const std::filesystem::path& folder,
                           const GltfOptions& options);

}  // namespace pelt::asset
