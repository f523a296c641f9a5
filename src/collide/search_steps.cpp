/// Steps of a collision search. Each step replaces one open item by items for parts of the same
/// triangles, or tests the triangles of clusters. The region of a new item is that of the
/// old item, cut with the boxes of the new one; items with an empty region are dropped. So regions
/// shrink even where boxes computed on demand do not nest.
///
/// Items are replaced as in query/pair_descent.hpp, which says why there are three such functions.
/// This one computes a region for each new item.

#include "collide/search.hpp"

#include "collide/cluster_pair.hpp"
#include "collide/open_queue.hpp"
#include "collide/search_work.hpp"
#include "pose/open_node.hpp"
#include "query/pair_descent.hpp"

#include <algorithm>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Squared distance of the farthest corners of two boxes.
double squared_farthest(const Box4& a, const Box4& b) {
  const Float4 farthest = max(a.high - b.low, b.high - a.low);
  const double x = farthest[0], y = farthest[1], z = farthest[2];
  return x * x + y * y + z * z;
}

/// Least translation along an axis that parts two overlapping boxes.
float least_translation(const Box4& a, const Box4& b) {
  const Float4 least = min(a.high - b.low, b.high - a.low);
  return std::min({least[0], least[1], least[2]});
}

Box4 box_of_all(const OpenedNode& opened) {
  return {load4(opened.all_low), load4(opened.all_high)};
}

Box4 region_of(const OpenItem& item) { return {load4(item.low), load4(item.high)}; }

bool is_empty(const Box4& box) { return ((box.low <= box.high).bits() & 7) != 7; }

/// The part of a region in the box of a slot, or the whole region.
struct Part {
  explicit Part(const Box4& region) {
    store4(low, region.low);
    store4(high, region.high);
  }

  Part(const Part& region, const OpenedNode& opened, unsigned slot)
      : Part(intersect(
            {load4(region.low), load4(region.high)},
            {Float4(opened.low[0][slot], opened.low[1][slot], opened.low[2][slot], 0),
             Float4(opened.high[0][slot], opened.high[1][slot], opened.high[2][slot], 0)})) {}

  Box8 box() const { return point_box(low, high); }

  alignas(16) float low[4], high[4];
};

/// One side of the search.
struct Side {
  const PosedTree& posed;
  NodeSet& needed;
};

class Steps {
 public:
  Steps(const PosedTree& a, const PosedTree& b, SearchState& state)
      : a_{a, state.needed_a},
        b_{b, state.needed_b},
        state_(state),
        queue_(state.items),
        triangles_(a.tree, b.tree, state.found, work_),
        base_(state.work.done),
        stops_at_first_(state.order == SearchOrder::first_contact && state.found.empty()) {}

  QueryStats run() {
    while (!queue_.is_empty() && state_.work.is_left()) step(queue_.pop());
    triangles_.flush();
    return work_;
  }

 private:
  void step(const OpenItem& item) {
    if (item.step == ItemStep::compare) return compare(item);
    if (item.step == ItemStep::replace_b) return replace_b(item);
    test(item.node_a, static_cast<unsigned>(std::countr_zero(unsigned{item.slots_a})), item.node_b,
         item.slots_b);
  }

  /// Counts the work of a step. The waiting triangles count already, so that the size of slices
  /// makes no difference.
  void end_step() { state_.work.end_step(base_ + work_.triangle_pairs + triangles_.waiting()); }

  const OpenedNode& open(const Side& side, std::uint32_t index) {
    base_ += work_to_need(side.posed, index, side.needed);
    return open_node(side.posed, index, work_);
  }

  /// Lowers the upper bound of the distance of the two bodies. Each box contains vertices of its
  /// body.
  void note_distance(const Box4& a, const Box4& b) {
    state_.squared_reach = std::min(state_.squared_reach, squared_farthest(a, b));
  }

  void add(ItemStep step, std::uint32_t node_a, unsigned slots_a, std::uint32_t node_b,
           unsigned slots_b, const Part& region, float depth) {
    const std::uint32_t place = queue_.make();
    new_[count_++] = {place, depth};
    OpenItem& item = queue_[place];
    store4(item.low, load4(region.low));
    store4(item.high, load4(region.high));
    item.node_a = node_a;
    item.node_b = node_b;
    item.slots_a = static_cast<std::uint8_t>(slots_a);
    item.slots_b = static_cast<std::uint8_t>(slots_b);
    item.step = step;
    item.depth = depth;
  }

  void compare(const OpenItem& item) {
    ++work_.node_pairs;
    base_ += kNodePairWork;
    const OpenedNode &opened_a = open(a_, item.node_a), &opened_b = open(b_, item.node_b);
    const Box4 all_a = box_of_all(opened_a), all_b = box_of_all(opened_b);
    note_distance(all_a, all_b);
    const Box4 common = intersect(intersect(all_a, all_b), region_of(item));
    if (is_empty(common)) return end_step();
    const Part region(common);
    const Node &node_a = a_.posed.tree.nodes[item.node_a],
               &node_b = b_.posed.tree.nodes[item.node_b];
    const unsigned near_a = item.slots_a & slots_in(opened_a, region.box());
    unsigned clusters_near[kMaxSlots] = {};     // clusters of b that each cluster of a overlaps
    unsigned slots_of_child_b[kMaxSlots] = {};  // clusters of a that each child of b overlaps
    count_ = 0;
    for (SetBits slot(near_a); slot; ++slot) {
      const Part part(region, opened_a, *slot);
      const unsigned near_b = item.slots_b & slots_in(opened_b, part.box());
      if (near_b == 0) continue;
      if (*slot >= node_a.cluster_count) {
        add(ItemStep::replace_b, child(node_a, *slot), kAllSlots, item.node_b, near_b, part,
            BoxOverlap::depth(opened_a, *slot, opened_b));
        continue;
      }
      clusters_near[*slot] = near_b & clusters_of(node_b);
      for (SetBits other(near_b & ~clusters_of(node_b)); other; ++other)
        slots_of_child_b[*other] |= 1u << *slot;
    }
    for (std::uint32_t slot = node_b.cluster_count; slot < kMaxSlots; ++slot)
      if (const unsigned slots_a = slots_of_child_b[slot])
        add(ItemStep::compare, item.node_a, slots_a, child(node_b, slot), kAllSlots,
            Part(region, opened_b, slot), BoxOverlap::depth(opened_b, slot, opened_a));
    push_new(item.rank);
    end_step();
    test_clusters(item, region, clusters_near);
  }

  /// Tests the clusters of two nodes, one cluster of a in each step. Pushes the clusters for which
  /// no work is left.
  void test_clusters(const OpenItem& item, const Part& region,
                     const unsigned (&clusters_near)[kMaxSlots]) {
    const std::uint32_t count = a_.posed.tree.nodes[item.node_a].cluster_count;
    std::uint32_t slot = 0;
    for (; slot < count && state_.work.is_left(); ++slot)
      if (clusters_near[slot] != 0) test(item.node_a, slot, item.node_b, clusters_near[slot]);
    const OpenedNode& opened_a = *a_.posed.opened[item.node_a];
    const OpenedNode& opened_b = *b_.posed.opened[item.node_b];
    count_ = 0;
    for (std::uint32_t left = count; left-- > slot;)
      if (clusters_near[left] != 0)
        add(ItemStep::test, item.node_a, 1u << left, item.node_b, clusters_near[left],
            Part(region, opened_a, left), BoxOverlap::depth(opened_a, left, opened_b));
    for (std::uint32_t i = 0; i < count_; ++i) queue_.push(new_[i].place, OpenItems::kDepthFirst);
  }

  /// Replaces b's node by its slots. After a's child was opened, fewer may overlap.
  void replace_b(const OpenItem& item) {
    const OpenedNode &opened_a = open(a_, item.node_a), &opened_b = open(b_, item.node_b);
    base_ += kNodePairWork / 2;
    const Box4 common = intersect(box_of_all(opened_a), region_of(item));
    if (is_empty(common)) return end_step();
    const Part region(common);
    const Node& node_b = b_.posed.tree.nodes[item.node_b];
    const unsigned slots_b = item.slots_b & slots_in(opened_b, region.box());
    count_ = 0;
    if (const unsigned clusters = slots_b & clusters_of(node_b))
      add(ItemStep::compare, item.node_a, kAllSlots, item.node_b, clusters, region, item.depth);
    for (SetBits slot(slots_b & ~clusters_of(node_b)); slot; ++slot) {
      const Part part(region, opened_b, *slot);
      if (const unsigned slots_a = slots_in(opened_a, part.box()))
        add(ItemStep::compare, item.node_a, slots_a, child(node_b, *slot), kAllSlots, part,
            BoxOverlap::depth(opened_b, *slot, opened_a));
    }
    push_new(item.rank);
    end_step();
  }

  /// Tests the triangles of one cluster of a and several clusters of b.
  void test(std::uint32_t node_a, unsigned slot_a, std::uint32_t node_b, unsigned slots_b) {
    const OpenedNode &opened_a = *a_.posed.opened[node_a], &opened_b = *b_.posed.opened[node_b];
    const PosedCluster cluster = {a_.posed, a_.posed.tree.nodes[node_a], opened_a, slot_a};
    const Node& nodes_b = b_.posed.tree.nodes[node_b];
    for (SetBits slot_b(slots_b); slot_b; ++slot_b) {
      base_ += kClusterPairWork;
      triangles_.add(cluster, {b_.posed, nodes_b, opened_b, *slot_b});
    }
    if (stops_at_first_) triangles_.flush();
    end_step();
    if (stops_at_first_ && !state_.found.empty()) state_.work.granted = state_.work.done;
  }

  /// Pushes the items that a step has added, which are parts of an item of this rank.
  void push_new(std::uint32_t rank_of_whole) {
    const bool is_full = queue_.size() + count_ > state_.max_open;
    if (state_.order == SearchOrder::first_contact || is_full) put_deepest_last();
    for (std::uint32_t i = 0; i < count_; ++i)
      queue_.push(new_[i].place, is_full ? OpenItems::kDepthFirst
                                         : rank_of(state_, queue_[new_[i].place], rank_of_whole));
  }

  void put_deepest_last() {
    for (NewItem* item = new_; item < new_ + count_; ++item) {
      const NewItem moved = *item;
      NewItem* place = item;
      for (; place > new_ && moved.depth < place[-1].depth; --place) *place = place[-1];
      *place = moved;
    }
  }

  /// An item that is not in the queue yet.
  struct NewItem {
    std::uint32_t place;
    float depth;
  };

  /// A step adds at most one item for each slot of a, and one for each slot of b.
  static constexpr std::uint32_t kMostNew = 2 * kMaxSlots;

  Side a_, b_;
  SearchState& state_;
  OpenQueue queue_;
  QueryStats work_;
  TrianglePairs<Stack<Contact>> triangles_;
  std::uint64_t base_;  ///< work without the triangle pairs of this run
  const bool stops_at_first_;
  NewItem new_[kMostNew];
  std::uint32_t count_ = 0;
};

}  // namespace

QueryStats start_search(const PosedTree& a, const PosedTree& b, SearchState& state) {
  QueryStats work;
  work.node_pairs = 1;
  state.items.clear();
  state.found.clear();
  clear_needed(state.needed_a, a.tree);
  clear_needed(state.needed_b, b.tree);
  state.work.start(kNodePairWork + 2 * kRefitWork);
  const RootBox &root_a = root_box(a, work), &root_b = root_box(b, work);
  const Box4 box_a = {load4(root_a.low), load4(root_a.high)};
  const Box4 box_b = {load4(root_b.low), load4(root_b.high)};
  state.squared_reach = squared_farthest(box_a, box_b);
  const Box4 region = intersect(box_a, box_b);
  if (is_empty(region)) return work;
  make_table(a);
  make_table(b);
  OpenItem item = {};
  store4(item.low, region.low);
  store4(item.high, region.high);
  item.slots_a = item.slots_b = static_cast<std::uint8_t>(kAllSlots);
  item.step = ItemStep::compare;
  item.depth = least_translation(box_a, box_b);
  state.whole_size = sorted_sides(item)[2];
  OpenQueue queue(state.items);
  const std::uint32_t place = queue.make();
  queue[place] = item;
  queue.push(place, OpenItems::kDepthFirst);
  return work;
}

QueryStats advance_search(const PosedTree& a, const PosedTree& b, SearchState& state) {
  return Steps(a, b, state).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
