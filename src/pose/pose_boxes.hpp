#pragma once

/// The root box of an instance, and the boxes around given vertices.

#include <pelt/math.hpp>

#include "base/arena.hpp"
#include "base/instruction_set.hpp"
#include "base/problem.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "skin/palette.hpp"

#include <cstddef>
#include <span>

namespace pelt::detail {

/// Exact box of all vertices below a node. The fourth of each is meaningless.
struct GivenBox {
  float low[4], high[4];
};

/// View of the given vertices of an instance, or of none. The boxes of all nodes are known, so
/// queries open only the nodes that they visit, as with posed vertices.
struct GivenVertices {
  const float* positions = nullptr;  ///< [P] four floats per vertex, in the order of the pools
  const GivenBox* boxes = nullptr;   ///< [N]

  explicit operator bool() const { return positions != nullptr; }

  /// The vertices from a position in the pools on.
  const float* at(std::uint32_t place) const {
    return positions + std::size_t{kFloatsPerVertex} * place;
  }

  Vec3 vertex(std::uint32_t place) const {
    const float* p = at(place);
    return {p[0], p[1], p[2]};
  }
};

/// Bytes of the arrays of given vertices.
inline std::size_t bytes_of_positions(const Tree& tree) {
  return tree.rest_positions.size() * kFloatsPerVertex * sizeof(float);
}
inline std::size_t bytes_of_boxes(const Tree& tree) { return tree.nodes.size() * sizeof(GivenBox); }

/// Copies given vertices to `arena`. O(P).
GivenVertices copy_given(const Tree& tree, const GivenVertices& given, Arena& arena);

/// Validates the caller's vertices [V]. Returns an empty Problem if they are valid. O(V).
Problem check_vertices(const Tree& tree, std::span<const Vec3> vertices);

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

inline namespace PELT_INSTRUCTION_SET {

/// Whether no coordinate is NaN or beyond kMaxCoordinate.
bool are_within(std::span<const Vec3> vertices);

/// Copies the caller's vertices [V] to `arena` and computes the boxes of all nodes bottom-up.
/// Precondition: `check_vertices` finds no problem. O(P).
GivenVertices refit_given(const Tree& tree, std::span<const Vec3> vertices, Arena& arena);

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail
