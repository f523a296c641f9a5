#pragma once

/// Reads a glTF file.

#include <pelt/asset.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace pelt::asset {

/// Moves the rest positions of unskinned parts from the frame of their node to their place in the
/// default pose, and sets the inverse matrices of their joints accordingly. Posed positions are the
/// same up to rounding. The rest pose then is the assembled character, with the sword in the hand
/// and not inside the shield, so bounding volumes built over it are tight.
///
/// Does not change parts whose node has the identity or a singular matrix in the default pose.
void assemble(Asset& asset);

struct ReadGltf {
  Asset asset;
  std::vector<std::uint32_t> views;  ///< buffer views that meshes and clips use, ascending
};

/// Like `load_gltf`, and also returns the views that it has read.
Result<ReadGltf> read_gltf(std::span<const std::byte> file, const std::filesystem::path& folder,
                           const GltfOptions& options);

}  // namespace pelt::asset
