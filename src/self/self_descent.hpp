#pragma once

/// The descent of a tree against itself: pairs of nodes are replaced by pairs of their slots until
/// clusters meet clusters. All nodes are open, so nothing is gained by opening one side of a pair
/// before the other, as PairDescent does (query/pair_descent.hpp): all pairs of slots of two nodes
/// are compared at once. The recursion is at most twice as deep as the tree.
///
/// `View` is a PosedTree, or a step of two poses (motion/moving_tree.hpp). It has a `tree`, and
/// overlapping_slots(view, a, b) returns the pairs of slots of two nodes whose boxes overlap.
///
/// `Rule` decides what happens at the leaves:
///   void test(std::uint32_t low, std::uint32_t high)   two clusters whose boxes overlap
///   bool is_full() const                               ends the descent

#include <pelt/query.hpp>

#include "query/slots.hpp"
#include "self/pair_masks.hpp"

#include <bit>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

inline SlotMatrix overlapping_slots(const PosedTree& posed, std::uint32_t a, std::uint32_t b) {
  const OpenedNode &opened_a = *posed.opened[a], &opened_b = *posed.opened[b];
  SlotMatrix matrix = 0;
  for (unsigned row = 0; row < kMaxSlots; ++row)
    matrix |= SlotMatrix{slots_in(opened_b, lane_box(opened_a.low, opened_a.high, row))} << 8 * row;
  return matrix;
}

template <typename View, typename Rule>
class SelfDescent {
 public:
  SelfDescent(const View& view, const PairMasks& masks, Rule& rule, QueryStats& work)
      : view_(view), masks_(masks), rule_(rule), work_(work) {}

  /// Visits each pair of different clusters that are no neighbours once.
  void run() {
    const auto node_count = static_cast<std::uint32_t>(view_.tree.nodes.size());
    for (std::uint32_t n = 0; n < node_count && !rule_.is_full(); ++n) compare(n, n, kLaterSlots);
  }

 private:
  /// Visits the pairs of slots of two nodes that are asked for. Precondition: a <= b.
  void compare(std::uint32_t a, std::uint32_t b, SlotMatrix asked) {
    ++work_.node_pairs;
    const SlotMatrix near = asked & overlapping_slots(view_, a, b);
    const Node &node_a = view_.tree.nodes.data()[a], &node_b = view_.tree.nodes.data()[b];
    const SlotMatrix clusters = first_slots(node_a.cluster_count, node_b.cluster_count);
    for (SlotMatrix pairs = near & clusters & ~masks_.neighbours(a, b); pairs; pairs &= pairs - 1) {
      const auto pair = static_cast<std::uint32_t>(std::countr_zero(pairs));
      rule_.test(node_a.first_cluster + pair / 8, node_b.first_cluster + pair % 8);
      if (rule_.is_full()) return;
    }
    if ((near & ~clusters) != 0) descend(a, b, near);
  }

  /// Visits each child with the children and with the clusters that it overlaps.
  void descend(std::uint32_t a, std::uint32_t b, SlotMatrix near) {
    const Node &node_a = view_.tree.nodes.data()[a], &node_b = view_.tree.nodes.data()[b];
    const unsigned clusters_a = clusters_of(node_a), clusters_b = clusters_of(node_b);
    for (SetBits i(kAllSlots & ~clusters_a); i; ++i) {
      const unsigned row = row_of(near, *i);
      for (SetBits j(row & ~clusters_b); j; ++j)
        visit(child(node_a, *i), kAllSlots, child(node_b, *j), kAllSlots);
      visit(child(node_a, *i), kAllSlots, b, row & clusters_b);
    }
    for (SetBits j(kAllSlots & ~clusters_b); j; ++j)
      visit(a, column_of(near, *j) & clusters_a, child(node_b, *j), kAllSlots);
  }

  void visit(std::uint32_t a, unsigned slots_a, std::uint32_t b, unsigned slots_b) {
    if (slots_a == 0 || slots_b == 0 || rule_.is_full()) return;
    a < b ? compare(a, b, all_pairs(slots_a, slots_b)) : compare(b, a, all_pairs(slots_b, slots_a));
  }

  const View& view_;
  const PairMasks& masks_;
  Rule& rule_;
  QueryStats& work_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
