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

/// Splits a .glb into its chunks. A file without the magic number of .glb is the JSON text of a
/// .gltf if it starts like a JSON object. O(number of chunks); copies nothing.
Result<Container> open_container(std::span<const std::byte> file);

}  // namespace pelt::asset
