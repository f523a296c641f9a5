#pragma once

/// Displacements of the vertices of a tree's pools, sorted by node and then by target. Opening a
/// node therefore costs nothing for targets that are inactive or displace no vertex of its pool.

#include "base/instruction_set.hpp"
#include "skin/morph_weights.hpp"

#include <pelt/math.hpp>

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// One target's displacements in one pool.
struct PoolTarget {
  std::uint32_t target = 0;
  std::uint32_t first_displacement = 0;  ///< into PoolMorphs::displacements
  std::uint32_t displacement_count = 0;  ///< at least one
};

/// Displacement of the vertex at `place` in Tree::rest_positions.
struct PlacedDisplacement {
  Vec3 by;  ///< not zero
  std::uint32_t place = 0;
};

struct PoolMorphs {
  std::vector<float> extents;             // [M] as in SkinnedMesh
  std::vector<std::uint32_t> node_begin;  // [N + 2] into targets; the last "node" has the vertices
                                          // that no triangle uses; empty if M is 0
  std::vector<PoolTarget> targets;        // ascending in each node
  std::vector<PlacedDisplacement> displacements;  // places ascending in each of these

  std::uint32_t target_count() const { return static_cast<std::uint32_t>(extents.size()); }
};

inline namespace PELT_INSTRUCTION_SET {

/// Calls `visit(item)` for each item with an active target. Precondition: the items ascend by
/// `target`. Cost: one step per item, or a few per active target, whichever is less.
template <typename Item, typename Visit>
inline void each_active(const Item* begin, const Item* end, const MorphWeights& morphs,
                        const Visit& visit) {
  const std::span<const std::uint32_t> active = morphs.active();
  if (static_cast<std::size_t>(end - begin) <= 8 * active.size()) {
    for (; begin != end; ++begin)
      if (morphs[begin->target] != 0) visit(*begin);
    return;
  }
  for (const std::uint32_t target : active) {
    for (std::ptrdiff_t count = end - begin; count > 0;) {  // find the first item that is not less
      const std::ptrdiff_t half = count / 2;
      const bool is_less = begin[half].target < target;
      begin += is_less ? half + 1 : 0;
      count = is_less ? count - half - 1 : half;
    }
    if (begin == end) return;
    if (begin->target == target) visit(*begin);
  }
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
