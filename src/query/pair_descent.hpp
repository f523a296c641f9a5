#pragma once

/// The simultaneous descent of two trees: pairs of nodes are replaced by pairs of their slots until
/// clusters meet clusters.
///
///      node of a            node of b         a slot of a against a slot of b:
///     [C C C N N]    x     [C C N N N]          cluster, cluster   Rule::test
///      |     |              |   |               child,   any       that child x the node of b
///      +- cluster           |   +- child        cluster, child     the node of a x that child
///            +- child       +- cluster
///
/// The caller pushes the pairs to start with. A tree against itself has a descent of its own
/// (self/self_descent.hpp).
///
/// Pairs are replaced in the same way in two searches that can be stopped
/// (collide/search_steps.cpp, collide/first_contact_steps.cpp). There are three such functions
/// because the pairs of these searches carry what prunes their parts, a region or times. This one
/// is the hottest loop of all queries, and carries nothing.
///
/// `View` is a PosedTree with `Opened` = OpenedNode and `PosedCluster`, or a step of two poses
/// (motion/moving_tree.hpp). It has a `tree`, and open_node(view, node, work) opens a node of it.
///
/// `Rule` decides what is pruned and what happens at the leaves:
///   bool overlaps(const Opened& a, const Opened& b) const         the whole nodes
///   unsigned slots_near(const Opened& of, const Opened& all)      slots of `of` near all of `all`
///   unsigned slots_near(const Opened& of, const Opened& other, unsigned slot)
///                                         slots of `of` that are near one slot of `other`
///   float depth(const Opened& a, unsigned slot, const Opened& b) const
///                                         how promising that slot is against the node b
///   void test(const PosedCluster& a, const PosedCluster& b)       two clusters that are near
///   bool is_full() const                  ends the descent
///   bool is_impatient() const             visits the most promising of new pairs first

#include "pose/open_node.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
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

template <typename View, typename Rule>
class PairDescent {
 public:
  PairDescent(const View& a, const View& b, Stack<SlotPair>& pairs, Rule& rule, QueryStats& work)
      : a_(a), b_(b), pairs_(pairs), rule_(rule), work_(work) {}

  /// Visits the pairs on the stack and all pairs below them. Precondition: there are tables of
  /// opened nodes.
  void run() {
    while (!pairs_.empty() && !rule_.is_full()) {
      const SlotPair pair = pairs_.pop();
      const std::size_t before = pairs_.size();
      if (pair.b_is_parent) {
        descend_b(pair);
      } else {
        compare(pair);
      }
      if (rule_.is_impatient()) put_deepest_last(before);
    }
  }

  /// Whether pairs are left that were not visited.
  bool is_unfinished() const { return is_unfinished_ || !pairs_.empty(); }

 private:
  decltype(auto) open_a(std::uint32_t node) { return open_node(a_, node, work_); }
  decltype(auto) open_b(std::uint32_t node) { return open_node(b_, node, work_); }

  /// Sorts the pairs from `first` on by depth, so that the deepest is popped next.
  void put_deepest_last(std::size_t first) {
    SlotPair* const begin = pairs_.begin() + first;
    for (SlotPair* pair = begin; pair < pairs_.end(); ++pair) {
      const SlotPair moved = *pair;
      SlotPair* place = pair;
      for (; place > begin && moved.depth < place[-1].depth; --place) *place = place[-1];
      *place = moved;
    }
  }

  /// Compares the slots of two nodes.
  void compare(const SlotPair& pair) {
    ++work_.node_pairs;
    const auto &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    if (!rule_.overlaps(opened_a, opened_b)) return;
    const Node &node_a = a_.tree.nodes[pair.node_a], &node_b = b_.tree.nodes[pair.node_b];
    const unsigned near_a = pair.slots_a & rule_.slots_near(opened_a, opened_b);
    unsigned slots_of_child_b[kMaxSlots] = {};  // clusters of a that each child of b overlaps
    for (SetBits slot(near_a); slot; ++slot) {
      const unsigned near_b = pair.slots_b & rule_.slots_near(opened_b, opened_a, *slot);
      if (near_b == 0) continue;
      if (*slot >= node_a.cluster_count) {
        pairs_.push({child(node_a, *slot), kAllSlots, pair.node_b, near_b, true,
                     rule_.depth(opened_a, *slot, opened_b)});
        continue;
      }
      for (SetBits other(near_b & clusters_of(node_b)); other; ++other) {
        rule_.test({a_, node_a, opened_a, *slot}, {b_, node_b, opened_b, *other});
        if (rule_.is_full()) return void(is_unfinished_ = true);
      }
      for (SetBits other(near_b & ~clusters_of(node_b)); other; ++other)
        slots_of_child_b[*other] |= 1u << *slot;
    }
    for (std::uint32_t slot = node_b.cluster_count; slot < kMaxSlots; ++slot)
      if (const unsigned slots_a = slots_of_child_b[slot])
        pairs_.push({pair.node_a, slots_a, child(node_b, slot), kAllSlots, false,
                     rule_.depth(opened_b, slot, opened_a)});
  }

  /// Pushes a child of a's node with the slots of b's node that its box overlaps. After opening,
  /// these may be fewer.
  void descend_b(const SlotPair& pair) {
    const auto &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    const Node& node_b = b_.tree.nodes[pair.node_b];
    const unsigned slots_b = pair.slots_b & rule_.slots_near(opened_b, opened_a);
    if (const unsigned clusters = slots_b & clusters_of(node_b))
      pairs_.push({pair.node_a, kAllSlots, pair.node_b, clusters, false, pair.depth});
    for (SetBits slot(slots_b & ~clusters_of(node_b)); slot; ++slot)
      if (const unsigned slots_a = rule_.slots_near(opened_a, opened_b, *slot))
        pairs_.push({pair.node_a, slots_a, child(node_b, *slot), kAllSlots, false,
                     rule_.depth(opened_b, *slot, opened_a)});
  }

  const View &a_, &b_;
  Stack<SlotPair>& pairs_;  // the top is visited next
  Rule& rule_;
  QueryStats& work_;
  bool is_unfinished_ = false;  // a visit ended early
};

/// Visits the pair of roots and all pairs below it. Returns whether pairs are left that were not
/// visited. Precondition: there are tables of opened nodes.
template <typename View, typename Rule>
bool descend_from_roots(const View& a, const View& b, Stack<SlotPair>& pairs, Rule& rule,
                        QueryStats& work) {
  pairs.clear();
  pairs.push({0, kAllSlots, 0, kAllSlots});
  PairDescent descent(a, b, pairs, rule, work);
  descent.run();
  return descent.is_unfinished();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
