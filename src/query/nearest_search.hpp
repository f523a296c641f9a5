#pragma once

/// Shared by searches by distance: distances of boxes, eight at a time; a conservative float bound
/// of a distance; parts of a tree; and slots of a node, nearest first.

#include "base/float8.hpp"
#include "base/instruction_set.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/open_node.hpp"
#include "query/slots.hpp"
#include "query/stack.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

[[gnu::always_inline]] inline Float8 gap(const Float8& low_a, const Float8& high_a,
                                         const Float8& low_b, const Float8& high_b) {
  return max(max(low_a - high_b, low_b - high_a), Float8(0.0f));
}

/// The squared distance of the boxes in each lane. Both arguments are Box8 or Boxes8.
template <typename BoxA, typename BoxB>
[[gnu::always_inline]] inline Float8 squared_gap(const BoxA& a, const BoxB& b) {
  const Float8 x = gap(a.low[0], a.high[0], b.low[0], b.high[0]);
  const Float8 y = gap(a.low[1], a.high[1], b.low[1], b.high[1]);
  const Float8 z = gap(a.low[2], a.high[2], b.low[2], b.high[2]);
  return x * x + y * y + z * z;
}

/// Returns the squared distances from `box` of the boxes starting at lane `first`, with a small
/// error in either direction (see Reach).
template <std::size_t kCount>
[[gnu::always_inline]] inline Float8 squared_gaps(const float (&low)[3][kCount],
                                                  const float (&high)[3][kCount], unsigned first,
                                                  const Box8& box) {
  return squared_gap(load_boxes(low, high, first), box);
}

/// Returns an upper bound of the difference of any two coordinates within two boxes.
inline double common_extent(const float* low_a, const float* high_a, const float* low_b,
                            const float* high_b) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = low_a[axis] < low_b[axis] ? low_a[axis] : low_b[axis];
    const double high = high_a[axis] > high_b[axis] ? high_a[axis] : high_b[axis];
    most = high - low > most ? high - low : most;
  }
  return most;
}

/// Conservative float bounds of a distance. Anything beyond these bounds is certainly farther away
/// than the distance.
///
/// Rounding. With e = 2^-24, gaps of boxes take one rounding, their squares three, sums two more
/// and underflow at most 2^-148: within (1 + 8 e) and 2^-148 of what boxes of the real vertices
/// have. The scalar distance may be kDistanceError times the largest difference of two coordinates
/// below the real one. Nothing overflows: gaps are at most those of posed vertices, below 2^62.
class Reach {
 public:
  /// `extent`: upper bound of the difference of any two coordinates in the query.
  explicit Reach(double extent) : slack_(extent * kDistanceError) {}

  void set(double distance) {
    const double beyond = (distance + slack_) * (1 + 0x1p-20) + 0x1p-120;
    gap_ = static_cast<float>(beyond < FLT_MAX ? beyond : FLT_MAX);
    const double squared = beyond * beyond + 0x1p-120;
    squared_gap_ = static_cast<float>(squared < FLT_MAX ? squared : FLT_MAX);
  }

  /// Lower bound of the distance of things whose boxes have this squared gap.
  double least_distance(float squared_gap) const {
    const double gap = std::sqrt(std::max(double{squared_gap} - 0x1p-120, 0.0)) - 0x1p-120;
    return std::max(gap / (1 + 0x1p-20) - slack_, 0.0);
  }

  /// For gaps of points along a direction.
  float gap() const { return gap_; }
  /// For squared gaps of boxes.
  float squared_gap() const { return squared_gap_; }

 private:
  double slack_;
  float gap_ = FLT_MAX, squared_gap_ = FLT_MAX;
};

/// A part of a posed tree: the whole tree, or a slot of an opened node.
struct TreePart {
  std::uint32_t node = 0;  ///< opened, unless the part is the whole tree
  std::uint32_t slot = kWhole;

  static constexpr std::uint32_t kWhole = kMaxSlots;
};

inline bool is_cluster(const PosedTree& posed, const TreePart& part) {
  return part.slot < posed.tree.nodes[part.node].cluster_count;
}

/// Returns the node of the part. Precondition: the part is not a cluster.
inline std::uint32_t node_of(const PosedTree& posed, const TreePart& part) {
  return part.slot == TreePart::kWhole ? 0 : child(posed.tree.nodes[part.node], part.slot);
}

/// Precondition: the part is a cluster.
inline PosedCluster cluster_of(const PosedTree& posed, const TreePart& part) {
  return {posed, posed.tree.nodes[part.node], *posed.opened[part.node], part.slot};
}

/// Returns the smallest known box around the part, opened or not.
inline Box8 known_box(const PosedTree& posed, const TreePart& part) {
  if (!is_cluster(posed, part)) {
    if (const OpenedNode* opened = posed.opened[node_of(posed, part)])
      return point_box(opened->all_low, opened->all_high);
    if (part.slot == TreePart::kWhole) return point_box(posed.root_box.low, posed.root_box.high);
  }
  const OpenedNode& parent = *posed.opened[part.node];
  return lane_box(parent.low, parent.high, part.slot);
}

/// Pushes `make(slot, gap)` for each slot of `slots`, the nearest last.
template <typename Item, typename Make>
void push_nearest_last(Stack<Item>& items, unsigned slots, const Float8& squared_gaps,
                       const Make& make) {
  alignas(32) float gap[kMaxSlots];
  squared_gaps.store(gap);
  const std::size_t first = items.size();
  for (SetBits slot(slots); slot; ++slot) {
    items.push(make(*slot, gap[*slot]));
    const Item moved = items.end()[-1];
    Item* place = items.end() - 1;
    for (; place > items.begin() + first && place[-1].squared_gap < moved.squared_gap; --place)
      *place = place[-1];
    *place = moved;
  }
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
