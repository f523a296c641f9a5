#pragma once

/// Boxes of vertices, and the vertex that is farthest along a direction.

#include <pelt/bounds.hpp>
#include <pelt/query.hpp>

#include "base/instruction_set.hpp"
#include "model/node_bounds.hpp"
#include "pose/posed_tree.hpp"
#include "skin/palette.hpp"

#include <cstdint>
#include <span>

namespace pelt::detail {

/// A box with positive zeros, and the work of computing it.
struct BoxFound {
  float low[4], high[4];  ///< the fourth of each is meaningless
  QueryStats work;
};

/// `direction` times a power of two: its largest component is in [1, 2).
Vec3 scaled_direction(const Vec3& direction);

/// The exact sign of dot(direction, p) - dot(direction, q).
int compare_along(const Vec3& direction, const Vec3& p, const Vec3& q);

inline namespace PELT_INSTRUCTION_SET {

/// Returns a box of all vertices of triangles, after opening the given number of levels. The box is
/// exact if the tree has no more levels.
BoxFound bounding_box(const PosedTree& posed, std::uint32_t levels);

/// Returns the bound of a set of vertices as a box, which is empty for an empty set.
BoxFound bound_of_set(const NodeBounds& bounds, std::uint32_t set, const Palette& palette);

/// Returns the exact box of the given vertices at these positions in the pools.
BoxFound box_given(const GivenVertices& given, std::span<const std::uint32_t> places);

/// Returns the exact box of the posed vertices at these positions in the pools.
BoxFound box_places(const Tree& tree, const Palette& palette,
                    std::span<const std::uint32_t> places);

/// Returns an upper bound of the distance of posed vertices from `centre` (four floats), or
/// infinity if the bound of the root node is affine. Precondition: no coordinate of `centre`
/// exceeds 2^64.
float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre);

/// Finds the vertex of a triangle that is farthest along `direction`, and stores it in `farthest`.
QueryStats find_farthest(const PosedTree& posed, const Vec3& direction, FarthestVertex& farthest);

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail
