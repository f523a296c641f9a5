/// The descent of two trees (Kavan & Zara 2005, section 4.2): node pairs whose boxes overlap are
/// replaced by pairs of their slots until clusters meet clusters. A node is opened when a box that
/// is known overlaps its bound. Opening may show that the exact boxes do not overlap after all, so
/// one side of a pair is opened before the other is touched.

#include "query/pair_traversal.hpp"

#include "model/node_box.hpp"
#include "pose/open_node.hpp"
#include "query/cluster_pair.hpp"
#include "query/lanes.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

constexpr unsigned kAllSlots = (1u << kMaxSlots) - 1;

bool overlap(const float* low_a, const float* high_a, const float* low_b, const float* high_b) {
  const Mask4 below = load4(low_a) <= load4(high_b), above = load4(low_b) <= load4(high_a);
  return ((below & above).bits() & 7) == 7;
}

bool overlap(const OpenedNode& a, const OpenedNode& b) {
  return overlap(a.all_low, a.all_high, b.all_low, b.all_high);
}

/// The slots of an opened node whose boxes overlap `box`.
unsigned slots_in(const OpenedNode& opened, const Box8& box) {
  return overlapping(opened.low, opened.high, 0, box);
}

unsigned clusters_of(const Node& node) { return (1u << node.cluster_count) - 1; }

class PairTraversal {
 public:
  PairTraversal(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                std::uint32_t max_contacts)
      : a_(a),
        b_(b),
        scratch_(scratch),
        max_contacts_(max_contacts),
        triangles_(scratch.found, work_) {}

  QueryStats run() {
    scratch_.found.clear();
    scratch_.slot_pairs.clear();
    if (!roots_overlap()) return work_;
    make_table(a_);
    make_table(b_);
    push({0, kAllSlots, 0, kAllSlots});
    while (!scratch_.slot_pairs.empty() && !is_full()) visit(scratch_.slot_pairs.pop());
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

  /// Whether to test candidates at once instead of collecting eight.
  bool is_impatient() const { return max_contacts_ - scratch_.found.size() < 8; }

  bool is_full() const { return scratch_.found.size() >= max_contacts_; }

  void cut() {
    work_.cut_short =
        is_unfinished_ || !scratch_.slot_pairs.empty() || scratch_.found.size() > max_contacts_;
    scratch_.found.shrink(max_contacts_);
  }

  /// Keeps the pair unless the opened nodes are apart.
  void push(const SlotPair& pair) {
    ++work_.node_pairs;
    if (overlap(open_a(pair.node_a), open_b(pair.node_b))) scratch_.slot_pairs.push(pair);
  }

  /// The slots of two opened nodes against each other.
  void visit(const SlotPair& pair) {
    const OpenedNode &opened_a = open_a(pair.node_a), &opened_b = open_b(pair.node_b);
    const Node& node_b = b_.tree.nodes[pair.node_b];
    const Node& node_a = a_.tree.nodes[pair.node_a];
    const unsigned near_a =
        pair.slots_a & slots_in(opened_a, point_box(opened_b.all_low, opened_b.all_high));
    unsigned slots_of_child_b[kMaxSlots] = {};  // clusters of a that each child of b overlaps
    for (SetBits slot(near_a); slot; ++slot) {
      const unsigned near_b =
          pair.slots_b & slots_in(opened_b, lane_box(opened_a.low, opened_a.high, *slot));
      if (near_b == 0) continue;
      if (*slot >= node_a.cluster_count) {
        descend_a(node_a.first_child + *slot - node_a.cluster_count, pair.node_b, near_b);
        continue;
      }
      for (SetBits other(near_b & clusters_of(node_b)); other; ++other) {
        test({a_, node_a, opened_a, *slot}, {b_, node_b, opened_b, *other});
        if (is_full()) return void(is_unfinished_ = true);
      }
      for (SetBits other(near_b & ~clusters_of(node_b)); other; ++other)
        slots_of_child_b[*other] |= 1u << *slot;
    }
    for (std::uint32_t child = 0; child < node_b.child_count; ++child)
      if (const unsigned slots = slots_of_child_b[node_b.cluster_count + child])
        push({pair.node_a, slots, node_b.first_child + child, kAllSlots});
  }

  void test(const PosedCluster& a, const PosedCluster& b) {
    triangles_.add(a, b);
    if (is_impatient()) triangles_.flush();
  }

  /// A child of a's node against those slots of b's node that its bound overlaps.
  void descend_a(std::uint32_t child_a, std::uint32_t index_b, unsigned slots_b) {
    const OpenedNode &opened_a = open_a(child_a), &opened_b = open_b(index_b);
    const Node& node_b = b_.tree.nodes[index_b];
    slots_b &= slots_in(opened_b, point_box(opened_a.all_low, opened_a.all_high));
    if (const unsigned clusters = slots_b & clusters_of(node_b))
      push({child_a, kAllSlots, index_b, clusters});
    for (SetBits slot(slots_b & ~clusters_of(node_b)); slot; ++slot)
      push({child_a, kAllSlots, node_b.first_child + *slot - node_b.cluster_count, kAllSlots});
  }

  const PosedTree &a_, &b_;
  Scratch& scratch_;
  std::uint32_t max_contacts_;
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
