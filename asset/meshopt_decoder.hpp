#pragma once

#include "asset/document.hpp"

#include <cstddef>
#include <span>

namespace pelt::asset {

/// Decompresses bytes of EXT_meshopt_compression into `out`, and undoes every filter but that of
/// quaternions. Preconditions: `meshopt` follows the rules of the extension, and `out` has count *
/// stride bytes, at least one.
///
/// Uses the library meshoptimizer; in WebAssembly, the decoder passed in from JavaScript.
Result<void> decompress(const GltfMeshopt& meshopt, std::span<const std::byte> compressed,
                        std::span<std::byte> out);

}  // namespace pelt::asset
