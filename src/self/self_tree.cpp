/// A tree against itself, in a pose or in a step. Neighbouring triangles always touch, so every
/// node would be opened: all nodes are opened at once, bottom-up, which is cheaper. Pairs of
/// triangles that share no surface vertex are found by a descent, which skips the others by their
/// masks (pair_masks.hpp). Pairs that share one are found fan by fan (fan_pairs.hpp).

#include "self/self_tree.hpp"

#include "motion/moving_boxes.hpp"
#include "pose/open_node.hpp"
#include "query/scratch.hpp"
#include "self/cluster_pairs.hpp"
#include "self/fan_pairs.hpp"
#include "self/self_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

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

/// Tests the triangles of overlapping clusters that share no surface vertex. `Pairs`: ClusterPairs
/// or MovingClusterPairs.
template <typename Pairs, typename Sink>
class SeparateTriangles {
 public:
  SeparateTriangles(const SelfFilter& filter, Pairs& pairs, const Sink& sink)
      : filter_(filter), pairs_(pairs), sink_(sink) {}

  bool is_full() const { return sink_.is_full(); }

  /// Tests two clusters that are no neighbours.
  void test(std::uint32_t low, std::uint32_t high) {
    has_hubs(low, high) ? test_hubs(low, high) : pairs_.add(low, high, kNoneSkipped);
    if (sink_.is_impatient()) pairs_.flush();
  }

  /// Tests a cluster against itself and against the neighbours with higher numbers.
  void test_neighbours(std::uint32_t low) {
    const PairMasks& masks = filter_.masks;
    for (std::uint32_t i = masks.begin.data()[low]; i < masks.begin.data()[low + 1]; ++i) {
      if (pairs_.are_apart(i)) continue;
      const std::uint32_t high = masks.others.data()[i];
      has_hubs(low, high) ? test_hubs(low, high) : pairs_.add_neighbours(low, high, i);
      if (sink_.is_impatient()) pairs_.flush();
      if (is_full()) return;
    }
  }

 private:
  bool has_hubs(std::uint32_t low, std::uint32_t high) const {
    const std::uint8_t* const has_hub = filter_.masks.has_hub.data();
    return has_hub[low] & has_hub[high];
  }

  void test_hubs(std::uint32_t low, std::uint32_t high) {
    PairMask mask;
    filter_.masks.write_mask(filter_.tree(), filter_.fans, low, high, mask);
    pairs_.add(low, high, mask);
    pairs_.test_boxes();
  }

  static constexpr PairMask kNoneSkipped = {};

  const SelfFilter& filter_;
  Pairs& pairs_;
  const Sink& sink_;
};

/// Finds the pairs that share no surface vertex, until the sink is full. Distant pairs come first,
/// because neighbours rarely intersect.
template <typename View, typename Pairs, typename Sink>
void test_separate_triangles(const View& view, const SelfFilter& filter, Pairs& pairs,
                             const Sink& sink, QueryStats& work) {
  SeparateTriangles rule(filter, pairs, sink);
  SelfDescent(view, filter.masks, rule, work).run();
  const std::size_t cluster_count = view.tree.clusters.size();
  for (std::uint32_t c = 0; c < cluster_count && !rule.is_full(); ++c) rule.test_neighbours(c);
  if (!rule.is_full()) pairs.flush();
}

std::size_t position_count(const Tree& tree) {
  const Node& last = tree.nodes.back();
  return last.first_vertex + last.vertex_count;
}

Positions copy_positions(const PosedTree& posed, Stack<std::array<float, 4>>& positions) {
  positions.reserve(position_count(posed.tree));
  write_positions(posed, positions.begin());
  return positions.begin();
}

/// Copies the posed vertices of both ends.
MovingPositions copy_positions(const MovingTree& moving, Stack<std::array<float, 4>>& positions) {
  const std::size_t count = position_count(moving.tree);
  positions.reserve(2 * count);
  std::array<float, 4>* const from = positions.begin();
  write_positions(moving.from, from);
  write_positions(moving.to, from + count);
  return {from, from + count};
}

}  // namespace

SelfStats self_collide_tree(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                            Scratch& scratch, std::uint32_t max_contacts) {
  SelfStats stats;
  scratch.found.clear();
  make_table(posed);
  stats += open_all(posed);
  if (track && !track->begins_frame()) track = nullptr;
  if (track) begin_frame(posed, *track, stats);
  FilteredSink sink(filter, scratch.found, scratch.ring, max_contacts, stats.left_out);
  ClusterPairs pairs(posed, filter, track, scratch.boxes, sink, stats);
  test_separate_triangles(posed, filter, pairs, sink, stats);
  bool is_unfinished = sink.is_full();
  if (!is_unfinished) {
    const Positions positions =
        track ? track->positions.data() : copy_positions(posed, scratch.positions);
    float* const slack = track ? track->fan_slack.data() : nullptr;
    is_unfinished = test_fans(posed, filter.fans, positions, slack, sink, stats);
  }
  stats.cut_short = sink.cut(is_unfinished);
  return stats;
}

SelfMovingStats self_collide_moving_tree(const MovingTree& moving, const SelfFilter& filter,
                                         Scratch& scratch, const MovingOptions& options) {
  SelfMovingStats stats;
  scratch.moving.clear();
  for (const PosedTree* posed : {&moving.from, &moving.to}) {
    make_table(*posed);
    static_cast<QueryStats&>(stats) += open_all(*posed);
  }
  FilteredSink sink(filter, scratch.moving, scratch.ring, options.max_contacts, stats.left_out);
  MovingClusterPairs pairs(moving, filter, options, sink, stats);
  test_separate_triangles(moving, filter, pairs, sink, stats);
  bool is_unfinished = sink.is_full();
  if (!is_unfinished)
    is_unfinished = test_moving_fans(moving, filter.fans, copy_positions(moving, scratch.positions),
                                     options, sink, stats);
  stats.cut_short = sink.cut(is_unfinished);
  return stats;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
