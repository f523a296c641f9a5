#pragma once

#include <pelt/result.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace pelt::asset {

/// The parts of a glTF file, borrowed from its bytes.
struct Container {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  ///< the binary chunk of a .glb
};

/// Remedy for a file of another format.
inline constexpr const char* kExportGltf2 = ": export the character as glTF 2.0";

/// Splits a .glb into its chunks. A file without the magic number of .glb is the JSON text of a
/// .gltf if it starts like a JSON object. O(number of chunks); copies nothing.
Result<Container> open_container(std::span<const std::byte> file);

/// Returns an error if no file with this beginning is a .glb or a .gltf. A file of 4 bytes or more
/// needs only its beginning for this, so that other large files need not be read.
Result<void> check_beginning(std::span<const std::byte> beginning);

}  // namespace pelt::asset
