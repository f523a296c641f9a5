#pragma once

/// The simultaneous descent of two trees, or of a tree against itself: pairs of nodes are replaced
/// by pairs of their slots until clusters meet clusters.
///
///      node of a            node of b         a slot of a against a slot of b:
///     [C C C N N]    x     [C C N N N]          cluster, cluster   Rule::test
///      |     |              |   |               child,   any       that child x the node of b
///      +- cluster           |   +- child        cluster, child     the node of a x that child
///            +- child       +- cluster
///
/// The caller pushes the pairs to start with. For a tree against itself, `visit_within` visits the
/// pairs of different slots of one node; all nodes together then cover each pair of different
/// clusters exactly once.
///
/// `Rule` decides what is pruned and what happens at the leaves:
///   bool overlaps(const OpenedNode& a, const OpenedNode& b) const     the whole nodes
///   unsigned slots_near(const OpenedNode& of, const OpenedNode& all)  slots of `of` near all of
///   `all` unsigned slots_near(const OpenedNode& of, const OpenedNode& other, unsigned slot)
///                                         slots of `of` that are near one slot of `other`
///   unsigned slots_left_out(const Node& a, unsigned slot, std::uint32_t node_b) const
///                                         clusters of node b not to test with that cluster of a
///   float depth(const OpenedNode& a, unsigned slot, const OpenedNode& b) const
///                                         how promising that slot is against the node b
///   void test(const PosedCluster& a, const PosedCluster& b)           two clusters that are near
///   bool is_full() const                  ends the descent
///   bool is_impatient() const             visits the most promising of new pairs first

#include "pose/open_node.hpp"
#include "query/scratch.hpp"
#include "query/slots.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

template <typename Rule>
class PairDescent {
 public:
  PairDescent(const PosedTree& a, const PosedTree& b, Stack<SlotPair>& pairs, Rule& rule,
              QueryStats& work)
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

  /// Visits the pairs of different slots of one node, and all pairs below them. Preconditions: both
  /// trees are one, and the stack is empty.
  void visit_within(std::uint32_t index) {
    ++work_.node_pairs;
    const OpenedNode& opened = open_a(index);
    const Node& node = a_.tree.nodes.data()[index];
    ClustersNear near;
    for (SetBits slot(slots_of(node)); slot; ++slot) {
      const unsigned later = slots_of(node) & ~((2u << *slot) - 1);
      const unsigned near_slot = later & rule_.slots_near(opened, opened, *slot);
      if (*slot < node.cluster_count) {
        if (!test_cluster(node, opened, *slot, index, opened, near_slot, near)) return;
        continue;
      }
      for (SetBits other(near_slot); other; ++other)
        pairs_.push({child(node, *slot), kAllSlots, child(node, *other), kAllSlots, false,
                     rule_.depth(opened, *slot, opened)});
    }
    push_children(index, opened, node, opened, near);
    run();
  }

  /// Whether pairs are left that were not visited.
  bool is_unfinished() const { return is_unfinished_ || !pairs_.empty(); }

 private:
  const OpenedNode& open_a(std::uint32_t node) { return open_node(a_, node, work_); }
  const OpenedNode& open_b(std::uint32_t node) { return open_node(b_, node, work_); }

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

  /// The clusters of a's node that each child of b's node overlaps.
  struct ClustersNear {
    unsigned child[kMaxSlots] = {};
  };

  /// Tests a cluster of a's node against the clusters among the slots `near_b` of b's node, and
  /// notes the children. Returns false if the rule is full.
  bool test_cluster(const Node& node_a, const OpenedNode& opened_a, unsigned slot,
                    std::uint32_t index_b, const OpenedNode& opened_b, unsigned near_b,
                    ClustersNear& near) {
    const Node& node_b = b_.tree.nodes.data()[index_b];
    unsigned clusters = near_b & clusters_of(node_b);
    if (clusters != 0) clusters &= ~rule_.slots_left_out(node_a, slot, index_b);
    for (SetBits other(clusters); other; ++other) {
      rule_.test({a_, node_a, opened_a, slot}, {b_, node_b, opened_b, *other});
      if (rule_.is_full()) {
        is_unfinished_ = true;
        return false;
      }
    }
    for (SetBits other(near_b & ~clusters_of(node_b)); other; ++other)
      near.child[*other] |= 1u << slot;
    return true;
  }

  /// Pushes each child of b's node with the clusters of a's node that it overlaps.
  void push_children(std::uint32_t index_a, const OpenedNode& opened_a, const Node& node_b,
                     const OpenedNode& opened_b, const ClustersNear& near) {
    for (std::uint32_t slot = node_b.cluster_count; slot < kMaxSlots; ++slot)
      if (const unsigned slots_a = near.child[slot])
        pairs_.push({index_a, slots_a, child(node_b, slot), kAllSlots, false,
                     rule_.depth(opened_b, slot, opened_a)});
  }

  /// Compares the slots of two nodes.
  void compare(const SlotPair& pair) {
    ++work_.node_pairs;
    const OpenedNode &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    if (!rule_.overlaps(opened_a, opened_b)) return;
    const Node &node_a = a_.tree.nodes[pair.node_a], &node_b = b_.tree.nodes[pair.node_b];
    const unsigned near_a = pair.slots_a & rule_.slots_near(opened_a, opened_b);
    ClustersNear near;
    for (SetBits slot(near_a); slot; ++slot) {
      const unsigned near_b = pair.slots_b & rule_.slots_near(opened_b, opened_a, *slot);
      if (near_b == 0) continue;
      if (*slot >= node_a.cluster_count) {
        pairs_.push({child(node_a, *slot), kAllSlots, pair.node_b, near_b, true,
                     rule_.depth(opened_a, *slot, opened_b)});
      } else if (!test_cluster(node_a, opened_a, *slot, pair.node_b, opened_b, near_b, near)) {
        return;
      }
    }
    push_children(pair.node_a, opened_a, node_b, opened_b, near);
  }

  /// Pushes a child of a's node with the slots of b's node that its box overlaps. After opening,
  /// these may be fewer.
  void descend_b(const SlotPair& pair) {
    const OpenedNode &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    const Node& node_b = b_.tree.nodes[pair.node_b];
    const unsigned slots_b = pair.slots_b & rule_.slots_near(opened_b, opened_a);
    if (const unsigned clusters = slots_b & clusters_of(node_b))
      pairs_.push({pair.node_a, kAllSlots, pair.node_b, clusters, false, pair.depth});
    for (SetBits slot(slots_b & ~clusters_of(node_b)); slot; ++slot)
      if (const unsigned slots_a = rule_.slots_near(opened_a, opened_b, *slot))
        pairs_.push({pair.node_a, slots_a, child(node_b, *slot), kAllSlots, false,
                     rule_.depth(opened_b, *slot, opened_a)});
  }

  const PosedTree &a_, &b_;
  Stack<SlotPair>& pairs_;  // the top is visited next
  Rule& rule_;
  QueryStats& work_;
  bool is_unfinished_ = false;  // a visit ended early
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
