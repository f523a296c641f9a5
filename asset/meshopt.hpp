#pragma once

/// EXT_meshopt_compression.

#include "asset/budget.hpp"
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

/// Decompresses a view of EXT_meshopt_compression. Before it allocates, rejects a count that is too
/// large for the number of compressed bytes. `what` names the view in messages.
Result<std::vector<std::byte>> decode_meshopt(const GltfMeshopt& meshopt,
                                              std::span<const std::byte> compressed, Budget& budget,
                                              const std::string& what);

/// The extension's quaternion filter, in place: four 16-bit numbers become a normalised rotation.
void decode_quaternion_filter(std::span<std::byte> bytes);

}  // namespace pelt::asset
