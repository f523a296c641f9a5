#pragma once

#include <pelt/asset.hpp>
#include <pelt/result.hpp>

#include <cstdint>
#include <vector>

namespace pelt::scenes {

/// What a person calls each triangle of a character: joint and part as the asset numbers them.
struct TriangleLabels {
  std::vector<std::uint16_t> joint;  ///< [T] that the triangle follows most, as ContactRegion's
  std::vector<std::uint32_t> part;   ///< [T] that has the triangle
};

/// Refuses what `build_model` refuses, but for weights that do not sum to 1. O(influences of all
/// vertices and triangles).
Result<TriangleLabels> label_triangles(const asset::Asset& asset);

}  // namespace pelt::scenes
