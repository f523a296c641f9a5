/// The descent of two trees: node pairs whose boxes overlap are replaced by pairs of their slots
/// until clusters meet clusters. A node is opened when a box that is known overlaps its bound
/// (refit on demand, Kavan & Zara 2005, section 4.2). Opening may show that the exact boxes do not
/// overlap after all, so one side of a pair is opened before the other is touched.

#include "collide/pair_traversal.hpp"

#include "collide/cluster_pair.hpp"
#include "pose/open_node.hpp"
#include "query/slots.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

bool overlap(const float* low_a, const float* high_a, const float* low_b, const float* high_b) {
  const Mask4 below = load4(low_a) <= load4(high_b), above = load4(low_b) <= load4(high_a);
  return ((below & above).bits() & 7) == 7;
}

bool overlap(const OpenedNode& a, const OpenedNode& b) {
  return overlap(a.all_low, a.all_high, b.all_low, b.all_high);
}

/// How far one would have to be moved along an axis to part a slot's box from the other node.
float depth(const OpenedNode& a, unsigned slot, const OpenedNode& b) {
  float least = HUGE_VALF;
  for (int axis = 0; axis < 3; ++axis) {
    const float left = a.high[axis][slot] - b.all_low[axis];
    const float right = b.all_high[axis] - a.low[axis][slot];
    const float smaller = left < right ? left : right;
    least = smaller < least ? smaller : least;
  }
  return least;
}

class PairTraversal {
 public:
  PairTraversal(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                std::uint32_t max_contacts)
      : a_(a),
        b_(b),
        scratch_(scratch),
        max_contacts_(max_contacts),
        pairs_(scratch.slot_pairs),
        triangles_(a.tree, b.tree, scratch.found, work_) {}

  QueryStats run() {
    pairs_.clear();
    scratch_.found.clear();
    if (!roots_overlap()) return work_;
    make_table(a_);
    make_table(b_);
    pairs_.push({0, kAllSlots, 0, kAllSlots});
    while (!pairs_.empty() && !is_full()) {
      const SlotPair pair = pairs_.pop();
      const std::size_t before = pairs_.size();
      if (pair.b_is_parent) {
        descend_b(pair);
      } else {
        compare(pair);
      }
      if (is_impatient()) put_deepest_last(before);
    }
    triangles_.flush();
    if (is_full()) cut();
    return work_;
  }

 private:
  const OpenedNode& open_a(std::uint32_t node) { return open_node(a_, node, work_); }
  const OpenedNode& open_b(std::uint32_t node) { return open_node(b_, node, work_); }

  bool roots_overlap() {
    ++work_.node_pairs;
    const RootBox &root_a = root_box(a_, work_), &root_b = root_box(b_, work_);
    return overlap(root_a.low, root_a.high, root_b.low, root_b.high);
  }

  /// Whether so few contacts are wanted that it pays to look where they are likely first, and to
  /// test candidates at once instead of collecting eight.
  bool is_impatient() const { return max_contacts_ - scratch_.found.size() < 8; }

  bool is_full() const { return scratch_.found.size() >= max_contacts_; }

  void cut() {
    work_.cut_short = is_unfinished_ || !pairs_.empty() || scratch_.found.size() > max_contacts_;
    scratch_.found.shrink(max_contacts_);
  }

  /// Sorts the pairs from `first` on by depth: the next one to be popped is the deepest.
  void put_deepest_last(std::size_t first) {
    SlotPair* const begin = pairs_.begin() + first;
    for (SlotPair* pair = begin; pair < pairs_.end(); ++pair) {
      const SlotPair moved = *pair;
      SlotPair* place = pair;
      for (; place > begin && moved.depth < place[-1].depth; --place) *place = place[-1];
      *place = moved;
    }
  }

  /// The slots of two nodes against each other.
  void compare(const SlotPair& pair) {
    ++work_.node_pairs;
    const OpenedNode &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    if (!overlap(opened_a, opened_b)) return;
    const Node &node_a = a_.tree.nodes[pair.node_a], &node_b = b_.tree.nodes[pair.node_b];
    const unsigned near_a =
        pair.slots_a & slots_in(opened_a, point_box(opened_b.all_low, opened_b.all_high));
    unsigned slots_of_child_b[kMaxSlots] = {};  // clusters of a that each child of b overlaps
    for (SetBits slot(near_a); slot; ++slot) {
      const unsigned near_b =
          pair.slots_b & slots_in(opened_b, lane_box(opened_a.low, opened_a.high, *slot));
      if (near_b == 0) continue;
      if (*slot >= node_a.cluster_count) {
        pairs_.push({child(node_a, *slot), kAllSlots, pair.node_b, near_b, true,
                     depth(opened_a, *slot, opened_b)});
        continue;
      }
      for (SetBits other(near_b & clusters_of(node_b)); other; ++other) {
        test({a_, node_a, opened_a, *slot}, {b_, node_b, opened_b, *other});
        if (is_full()) return void(is_unfinished_ = true);
      }
      for (SetBits other(near_b & ~clusters_of(node_b)); other; ++other)
        slots_of_child_b[*other] |= 1u << *slot;
    }
    for (std::uint32_t slot = node_b.cluster_count; slot < kMaxSlots; ++slot)
      if (const unsigned slots_a = slots_of_child_b[slot])
        pairs_.push({pair.node_a, slots_a, child(node_b, slot), kAllSlots, false,
                     depth(opened_b, slot, opened_a)});
  }

  /// A child of a's node against those slots of b's node that its bound overlaps: now that it is
  /// opened, fewer may be left.
  void descend_b(const SlotPair& pair) {
    const OpenedNode &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    const Node& node_b = b_.tree.nodes[pair.node_b];
    const unsigned slots_b =
        pair.slots_b & slots_in(opened_b, point_box(opened_a.all_low, opened_a.all_high));
    if (const unsigned clusters = slots_b & clusters_of(node_b))
      pairs_.push({pair.node_a, kAllSlots, pair.node_b, clusters, false, pair.depth});
    for (SetBits slot(slots_b & ~clusters_of(node_b)); slot; ++slot)
      if (const unsigned slots_a = slots_in(opened_a, lane_box(opened_b.low, opened_b.high, *slot)))
        pairs_.push({pair.node_a, slots_a, child(node_b, *slot), kAllSlots, false,
                     depth(opened_b, *slot, opened_a)});
  }

  void test(const PosedCluster& a, const PosedCluster& b) {
    triangles_.add(a, b);
    if (is_impatient()) triangles_.flush();
  }

  const PosedTree &a_, &b_;
  Scratch& scratch_;
  std::uint32_t max_contacts_;
  Stack<SlotPair>& pairs_;  // the one on top is next
  QueryStats work_;
  TrianglePairs triangles_;
  bool is_unfinished_ = false;  // a visit ended early
};

}  // namespace

QueryStats collide_trees(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return PairTraversal(a, b, scratch, max_contacts).run();
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
