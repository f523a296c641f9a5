#pragma once

#include "asset/budget.hpp"
#include "asset/document.hpp"

#include <span>

namespace pelt::asset {

/// The bytes of a view compressed by EXT_meshopt_compression. Refuses, before it allocates, a count
/// that so few bytes cannot have come from. `what` names the view.
Result<std::vector<std::byte>> decode_meshopt(const GltfMeshopt& meshopt,
                                              std::span<const std::byte> compressed, Budget& budget,
                                              const std::string& what);

/// The extension's quaternion filter, in place: four 16-bit numbers become a normalised rotation.
void decode_quaternion_filter(std::span<std::byte> bytes);

}  // namespace pelt::asset
