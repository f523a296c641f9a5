#pragma once

/// Pruning by boxes of the current poses, for PairDescent (pair_descent.hpp).

#include "pose/opened_node.hpp"
#include "query/lanes.hpp"
#include "query/slots.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

inline bool boxes_overlap(const float* low_a, const float* high_a, const float* low_b,
                          const float* high_b) {
  const Mask4 below = load4(low_a) <= load4(high_b), above = load4(low_b) <= load4(high_a);
  return ((below & above).bits() & 7) == 7;
}

/// The part of a Rule that decides which nodes and slots are near: those whose boxes overlap.
struct BoxOverlap {
  static bool overlaps(const OpenedNode& a, const OpenedNode& b) {
    return boxes_overlap(a.all_low, a.all_high, b.all_low, b.all_high);
  }

  static unsigned slots_near(const OpenedNode& of, const OpenedNode& all) {
    return slots_in(of, point_box(all.all_low, all.all_high));
  }

  static unsigned slots_near(const OpenedNode& of, const OpenedNode& other, unsigned slot) {
    return slots_in(of, lane_box(other.low, other.high, slot));
  }

  /// The least distance along an axis by which a slot's box would have to move to leave the other
  /// node's box.
  static float depth(const OpenedNode& a, unsigned slot, const OpenedNode& b) {
    float least = HUGE_VALF;
    for (int axis = 0; axis < 3; ++axis) {
      const float left = a.high[axis][slot] - b.all_low[axis];
      const float right = b.all_high[axis] - a.low[axis][slot];
      const float smaller = left < right ? left : right;
      least = smaller < least ? smaller : least;
    }
    return least;
  }
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
