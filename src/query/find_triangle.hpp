#pragma once

/// Finds triangles by the caller's numbers.

#include <pelt/query.hpp>

#include "geometry/triangle_pair.hpp"
#include "model/triangle_places.hpp"
#include "pose/posed_tree.hpp"

#include <cstdint>

namespace pelt::detail {

/// The corners of the triangle at `place`, which is in the opened node.
TriangleCorners corners_at(const Tree& tree, std::uint32_t place, const OpenedNode& opened);

/// The location of a triangle in an opened tree.
struct FoundTriangle {
  TriangleCorners corners;
  std::uint32_t node, slot;  ///< its cluster
};

/// Finds the triangle with the caller's number `id`. Opens its node if it is not open, which is
/// counted in `work`. Cost: O(log N). Preconditions: the triangle exists, and there is a table of
/// opened nodes.
FoundTriangle find_triangle(const PosedTree& posed, std::uint32_t id, QueryStats& work);

/// Reads the corners of triangles. Cost: O(1) for a triangle in the node of the triangle before,
/// otherwise O(log N).
class TriangleReader {
 public:
  /// Makes the table of opened nodes if there is none.
  explicit TriangleReader(const PosedTree& posed);

  /// The corners of the triangle with the caller's number `id`. Opens its node if it is not open,
  /// which is counted in `work`.
  TriangleCorners corners(std::uint32_t id, QueryStats& work);

 private:
  void move_to_node_of(std::uint32_t place);

  PosedTree posed_;
  std::uint32_t node_ = 0;
  Places places_;  ///< of the triangles of `node_`
};

}  // namespace pelt::detail
