#pragma once

#include <pelt/asset.hpp>

#include <cstdint>
#include <vector>

namespace pelt::tools {

/// What a person calls each triangle of a character.
struct TriangleLabels {
  std::vector<std::uint32_t> joint;  ///< of the greatest weight, summed over the three vertices
  std::vector<std::uint32_t> part;   ///< index into the asset's parts
};

/// O(influences of all triangles).
TriangleLabels label_triangles(const asset::Asset& asset);

}  // namespace pelt::tools
