/// A moving tree against itself, as `self_tree.cpp` for one pose: all nodes are opened in both
/// poses; a descent finds the pairs that share no surface vertex, and the others are found fan by
/// fan.

#include "self/self_moving_tree.hpp"

#include "motion/moving_boxes.hpp"
#include "motion/moving_pairs.hpp"
#include "motion/moving_triangles.hpp"
#include "pose/open_node.hpp"
#include "query/scratch.hpp"
#include "self/moving_fans.hpp"
#include "self/self_descent.hpp"
#include "self/slack.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Precondition: the node is open at both ends.
MovingNode opened_node(const MovingTree& moving, std::uint32_t node) {
  return {*moving.from.opened[node], *moving.to.opened[node]};
}

}  // namespace

/// For SelfDescent.
inline SlotMatrix overlapping_slots(const MovingTree& moving, std::uint32_t a, std::uint32_t b) {
  const MovingOverlap overlap;
  const MovingNode node_a = opened_node(moving, a), node_b = opened_node(moving, b);
  SlotMatrix matrix = 0;
  for (unsigned row = 0; row < kMaxSlots; ++row)
    matrix |= SlotMatrix{overlap.slots_near(node_b, node_a, row)} << 8 * row;
  return matrix;
}

namespace {

/// Tests the triangles of overlapping clusters that share no surface vertex.
class SeparateWhileMoving {
 public:
  SeparateWhileMoving(const MovingTree& moving, const SelfFilter& filter,
                      const MovingOptions& options, SelfAnswerOf<MovingContact>& answer,
                      MovingStats& work)
      : moving_(moving),
        filter_(filter),
        answer_(answer),
        pairs_(moving.tree, moving.tree),
        triangles_(pairs_, answer.contacts(), options, work) {}

  bool is_full() const { return answer_.is_full(); }

  /// Tests two clusters that are no neighbours.
  void test(std::uint32_t low, std::uint32_t high) {
    has_hubs(low, high) ? test_hubs(low, high) : add(low, high, kNoneSkipped);
  }

  /// Tests a cluster against itself and against the neighbours with higher numbers.
  void test_neighbours(std::uint32_t low) {
    const PairMasks& masks = filter_.masks;
    for (std::uint32_t i = masks.begin.data()[low]; i < masks.begin.data()[low + 1]; ++i) {
      const std::uint32_t high = masks.others.data()[i];
      has_hubs(low, high) ? test_hubs(low, high) : add(low, high, masks.masks.data()[i]);
      if (is_full()) return;
    }
  }

  void flush() {
    triangles_.flush();
    answer_.settle();
  }

 private:
  MovingCluster cluster(std::uint32_t number) const {
    const std::uint32_t n = filter_.masks.cluster_nodes.data()[number];
    const Node& node = moving_.tree.nodes.data()[n];
    return {moving_, node, opened_node(moving_, n), number - node.first_cluster};
  }

  bool has_hubs(std::uint32_t low, std::uint32_t high) const {
    const std::uint8_t* const has_hub = filter_.masks.has_hub.data();
    return has_hub[low] & has_hub[high];
  }

  void test_hubs(std::uint32_t low, std::uint32_t high) {
    PairMask mask;
    filter_.masks.write_mask(filter_.tree(), filter_.fans, low, high, mask);
    add(low, high, mask);
  }

  void add(std::uint32_t low, std::uint32_t high, const PairMask& skipped) {
    pairs_.add(
        cluster(low), cluster(high), OverlapUntil{overlap_.latest()}, [this] { flush(); },
        skipped.rows);
    if (answer_.is_impatient()) flush();
  }

  static constexpr PairMask kNoneSkipped = {};

  const MovingTree& moving_;
  const SelfFilter& filter_;
  SelfAnswerOf<MovingContact>& answer_;
  MovingOverlap overlap_;
  MovingPairs pairs_;
  MovingTriangles<MovingPairs> triangles_;
};

/// Finds the pairs that share no surface vertex, until the answer is full. Distant pairs come
/// first, because neighbours rarely intersect.
void test_separate_triangles(const MovingTree& moving, const SelfFilter& filter,
                             const MovingOptions& options, SelfAnswerOf<MovingContact>& answer,
                             MovingStats& work) {
  SeparateWhileMoving rule(moving, filter, options, answer, work);
  SelfDescent(moving, filter.masks, rule, work).run();
  const std::size_t cluster_count = moving.tree.clusters.size();
  for (std::uint32_t c = 0; c < cluster_count && !rule.is_full(); ++c) rule.test_neighbours(c);
  if (!rule.is_full()) rule.flush();
}

/// Copies the posed vertices of both ends.
MovingPositions copy_positions(const MovingTree& moving, Stack<std::array<float, 4>>& positions) {
  const Node& last = moving.tree.nodes.back();
  const std::size_t count = last.first_vertex + last.vertex_count;
  positions.reserve(2 * count);
  std::array<float, 4>* const from = positions.begin();
  write_positions(moving.from, from);
  write_positions(moving.to, from + count);
  return {from, from + count};
}

}  // namespace

SelfMovingStats self_collide_moving_tree(const MovingTree& moving, const SelfFilter& filter,
                                         Scratch& scratch, const MovingOptions& options) {
  SelfMovingStats stats;
  scratch.moving.clear();
  for (const PosedTree* posed : {&moving.from, &moving.to}) {
    make_table(*posed);
    static_cast<QueryStats&>(stats) += open_all(*posed);
  }
  SelfAnswerOf<MovingContact> answer(filter, scratch.moving, scratch.ring, options.max_contacts,
                                     stats.left_out);
  test_separate_triangles(moving, filter, options, answer, stats);
  bool is_unfinished = answer.is_full();
  if (!is_unfinished)
    is_unfinished = test_moving_fans(moving, filter.fans, copy_positions(moving, scratch.positions),
                                     options, answer, stats);
  stats.cut_short = answer.cut(is_unfinished);
  return stats;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
