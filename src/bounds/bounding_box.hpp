#pragma once

#include <pelt/query.hpp>

#include "base/target.hpp"
#include "pose/posed_tree.hpp"

#include <cstdint>
#include <span>

namespace pelt::detail {

/// A box whose zeros are positive, and the work that it took.
struct BoxFound {
  float low[4], high[4];  ///< the fourth of each is meaningless
  QueryStats work;
};

inline namespace PELT_TARGET {

/// A box around all corners of triangles, from so many levels of opened nodes; the exact one if
/// there are no more in the tree.
BoxFound bounding_box(const PosedTree& posed, std::uint32_t levels);

/// The bound of a set of vertices as a box; the one of an empty set is empty.
BoxFound bound_of_set(const NodeBounds& bounds, std::uint32_t set, const Palette& palette);

/// The exact box of the vertices at these places of the pools.
BoxFound box_places(const Tree& tree, const Palette& palette,
                    std::span<const std::uint32_t> places);

}  // namespace PELT_TARGET
}  // namespace pelt::detail
