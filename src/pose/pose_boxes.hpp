#pragma once

#include "base/instruction_set.hpp"
#include "model/node_bounds.hpp"
#include "pose/given_vertices.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {

/// Box of all vertices, computed when first needed.
struct RootBox {
  bool known = false;
  float low[4], high[4];
};

inline bool contains(const RootBox& box, const Vec3& p) {
  return box.low[0] <= p.x && p.x <= box.high[0] && box.low[1] <= p.y && p.y <= box.high[1] &&
         box.low[2] <= p.z && p.z <= box.high[2];
}

inline namespace PELT_INSTRUCTION_SET {

/// Computes the box from the joint palette and the morph weights, without posing vertices. Copies
/// it if the vertices are given.
RootBox box_root(const NodeBounds& bounds, const Palette& palette, const GivenVertices& given);

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Whether no coordinate is NaN or beyond kMaxCoordinate.
bool are_within(std::span<const Vec3> vertices);

/// Copies the caller's vertices [V] to `arena` and computes the boxes of all nodes bottom-up.
/// Precondition: `check_vertices` finds no problem. O(P).
GivenVertices refit_given(const Tree& tree, std::span<const Vec3> vertices, Arena& arena);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
