#pragma once

#include "asset/document.hpp"

#include <cstddef>
#include <span>

namespace pelt::asset {

/// Writes the elements that bytes of EXT_meshopt_compression hold, with the filter undone unless it
/// is that of quaternions. Preconditions: the extension's rules hold for `meshopt`, and `out` has
/// count * stride bytes, more than none.
///
/// By the library meshoptimizer; in WebAssembly by what JavaScript has handed over.
Result<void> decompress(const GltfMeshopt& meshopt, std::span<const std::byte> compressed,
                        std::span<std::byte> out);

}  // namespace pelt::asset
