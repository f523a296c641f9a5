#pragma once

/// Reduces a glTF file to the data that Pelt reads, for embedding.

#include <pelt/result.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace pelt::tools::page {

/// Returns a .glb from which Pelt reads the same asset as from `file`. It is a valid glTF file with
/// these buffer views, and without images, textures, looks of materials, attributes that Pelt does
/// not read, extras, and the data of extensions. Includes the bytes of external buffers.
///
/// `folder`: where external buffers are; empty if there are none. `views`: the views that Pelt
/// reads, ascending, as returned by `asset::read_gltf` for this file. Returns an error if the file
/// cannot be read or the copy would exceed 4 GB.
Result<std::vector<std::byte>> copy_geometry(std::span<const std::byte> file,
                                             const std::filesystem::path& folder,
                                             std::span<const std::uint32_t> views);

}  // namespace pelt::tools::page
