#pragma once

#include <pelt/asset.hpp>
#include <pelt/result.hpp>

#include <cstdint>
#include <vector>

namespace pelt::scenes {

/// Joint and part of each triangle of a character, as numbered in the asset.
struct TriangleLabels {
  std::vector<std::uint16_t> joint;  ///< [T] the joint of largest weight, as in ContactPatch
  std::vector<std::uint32_t> part;   ///< [T] the part with the triangle
};

/// Returns the errors of `build_model`, except for weights that do not sum to 1. O(influences of
/// all vertices and triangles).
Result<TriangleLabels> label_triangles(const asset::Asset& asset);

}  // namespace pelt::scenes
