#pragma once

/// Boxes in structure-of-arrays order, and lanes and slots of an opened node as bit sets.

#include "base/float8.hpp"
#include "pose/posed_tree.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The set bits of a mask, lowest first.
class SetBits {
 public:
  explicit SetBits(unsigned mask) : mask_(mask) {}

  explicit operator bool() const { return mask_ != 0; }
  unsigned operator*() const { return static_cast<unsigned>(std::countr_zero(mask_)); }
  void operator++() { mask_ &= mask_ - 1; }

 private:
  unsigned mask_;
};

/// One box, each bound in all eight lanes.
struct Box8 {
  Float8 low[3], high[3];
};

template <std::size_t kCount>
[[gnu::always_inline]] inline Box8 lane_box(const float (&low)[3][kCount],
                                            const float (&high)[3][kCount], unsigned lane) {
  return {{Float8(low[0][lane]), Float8(low[1][lane]), Float8(low[2][lane])},
          {Float8(high[0][lane]), Float8(high[1][lane]), Float8(high[2][lane])}};
}

[[gnu::always_inline]] inline Box8 point_box(const float (&low)[4], const float (&high)[4]) {
  return {{Float8(low[0]), Float8(low[1]), Float8(low[2])},
          {Float8(high[0]), Float8(high[1]), Float8(high[2])}};
}

/// Eight boxes, one per lane.
struct Boxes8 {
  Float8 low[3], high[3];
};

/// Loads eight boxes, starting at lane `first`.
template <std::size_t kCount>
[[gnu::always_inline]] inline Boxes8 load_boxes(const float (&low)[3][kCount],
                                                const float (&high)[3][kCount], unsigned first) {
  return {{load8(low[0] + first), load8(low[1] + first), load8(low[2] + first)},
          {load8(high[0] + first), load8(high[1] + first), load8(high[2] + first)}};
}

/// The same box in each lane, for functions that compare eight different boxes.
[[gnu::always_inline]] inline Boxes8 repeat(const Box8& box) {
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

/// Returns which of the eight boxes starting at lane `first` overlap `box`, one bit per box.
/// Touching counts.
template <std::size_t kCount>
[[gnu::always_inline]] inline unsigned overlapping(const float (&low)[3][kCount],
                                                   const float (&high)[3][kCount], unsigned first,
                                                   const Box8& box) {
  const Mask8 x = (load8(low[0] + first) <= box.high[0]) & (box.low[0] <= load8(high[0] + first));
  const Mask8 y = (load8(low[1] + first) <= box.high[1]) & (box.low[1] <= load8(high[1] + first));
  const Mask8 z = (load8(low[2] + first) <= box.high[2]) & (box.low[2] <= load8(high[2] + first));
  return (x & y & z).bits();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

namespace pelt::detail {

/// One cluster of an opened node.
struct PosedCluster {
  const PosedTree& posed;
  const Node& node;
  const OpenedNode& opened;
  std::uint32_t slot;

  const Cluster& cluster() const { return posed.tree.clusters[node.first_cluster + slot]; }
};

inline namespace PELT_INSTRUCTION_SET {

inline constexpr unsigned kAllSlots = (1u << kMaxSlots) - 1;

/// The slots in use, one bit each.
inline unsigned slots_of(const Node& node) {
  return (1u << (node.cluster_count + node.child_count)) - 1;
}

/// The slots that are clusters.
inline unsigned clusters_of(const Node& node) { return (1u << node.cluster_count) - 1; }

/// Index of the child node in `slot`. Precondition: the slot does not hold a cluster.
inline std::uint32_t child(const Node& node, unsigned slot) {
  return node.first_child + slot - node.cluster_count;
}

/// The slots whose boxes overlap `box`.
inline unsigned slots_in(const OpenedNode& opened, const Box8& box) {
  return overlapping(opened.low, opened.high, 0, box);
}

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail
