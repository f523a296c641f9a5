#pragma once

#include <pelt/query.hpp>

#include "geometry/triangle_pair.hpp"
#include "pose/posed_tree.hpp"

#include <cstdint>

namespace pelt::detail {

/// The location of a triangle in an opened tree.
struct FoundTriangle {
  TriangleCorners corners;
  std::uint32_t node, slot;  ///< its cluster
};

/// Finds the triangle with the caller's number `id`. Opens its node if it is not open, which is
/// counted in `work`. Cost: O(log N). Preconditions: the triangle exists, and there is a table of
/// opened nodes.
FoundTriangle find_triangle(const PosedTree& posed, std::uint32_t id, QueryStats& work);

}  // namespace pelt::detail
