/// A tree against itself. Neighbouring triangles always touch, so every node would be opened: all
/// nodes are opened at once, bottom-up, which is cheaper. Pairs of triangles that share no surface
/// vertex are found by a descent, which skips the others by their masks (pair_masks.hpp). Pairs
/// that share one are found fan by fan (fan_pairs.hpp).

#include "self/self_tree.hpp"

#include "collide/cluster_pair.hpp"
#include "pose/open_node.hpp"
#include "query/box_overlap.hpp"
#include "query/contact_sink.hpp"
#include "query/pair_descent.hpp"
#include "self/fan_pairs.hpp"
#include "self/neighbour_gaps.hpp"
#include "self/self_answer.hpp"
#include "self/slack.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters that share no surface vertex.
class SeparateTriangles : public BoxOverlap {
 public:
  SeparateTriangles(const SelfFilter& filter, SelfTrack* track, SelfAnswer& answer,
                    QueryStats& work)
      : filter_(filter),
        track_(track),
        answer_(answer),
        work_(work),
        triangles_(filter.tree(), filter.tree(), answer.contacts(), work) {}

  bool is_full() const { return answer_.is_full(); }
  bool is_impatient() const { return answer_.is_impatient(); }

  /// Neighbours are left to `test_neighbours`.
  unsigned slots_left_out(const Node& node, unsigned slot, std::uint32_t other) const {
    return filter_.masks.neighbours_in(node.first_cluster + slot, other);
  }

  void test(const PosedCluster& a, const PosedCluster& b) {
    const std::uint32_t in_a = a.node.first_cluster + a.slot, in_b = b.node.first_cluster + b.slot;
    const auto [low, high] = in_a < in_b ? std::pair(in_a, in_b) : std::pair(in_b, in_a);
    const PairMasks& masks = filter_.masks;
    if (masks.has_hub.data()[low] & masks.has_hub.data()[high])
      in_a < in_b ? test_hubs(a, low, b, high) : test_hubs(b, low, a, high);
    else
      triangles_.add(a, b);
    settle();
  }

  /// Tests a cluster against itself and against the neighbours with higher numbers.
  void test_neighbours(const PosedTree& posed, const PosedCluster& cluster) {
    const std::uint32_t low = cluster.node.first_cluster + cluster.slot;
    filter_.masks.for_each(
        posed.tree, low, [&](std::uint32_t mask, std::uint32_t n, std::uint32_t slot) {
          if (is_full() || (track_ && track_->pair_slack.data()[mask] > 0)) return;
          const Node& node = posed.tree.nodes.data()[n];
          test_neighbour(mask, cluster, low, {posed, node, *posed.opened[n], slot});
          settle();
        });
  }

  void flush() {
    triangles_.flush();
    answer_.settle();
  }

 private:
  void settle() {
    if (is_impatient()) triangles_.flush();
    answer_.settle();
  }

  void test_neighbour(std::uint32_t number, const PosedCluster& a, std::uint32_t low,
                      const PosedCluster& b) {
    const PairMasks& masks = filter_.masks;
    const std::uint32_t high = b.node.first_cluster + b.slot;
    const PairMask& mask = masks.masks.data()[number];
    if (masks.has_hub.data()[low] & masks.has_hub.data()[high])
      test_hubs(a, low, b, high);
    else if (track_ && track_->may_gain(number))
      track_->set_slack(low, number, test_gaps(a, b, mask.rows, track_->extent, triangles_, work_));
    else
      triangles_.add(a, b, mask.rows);
  }

  void test_hubs(const PosedCluster& a, std::uint32_t low, const PosedCluster& b,
                 std::uint32_t high) {
    PairMask mask;
    filter_.masks.write_mask(filter_.tree(), filter_.fans, low, high, mask);
    triangles_.add(a, b, mask.rows);
  }

  const SelfFilter& filter_;
  SelfTrack* track_;  // or null
  SelfAnswer& answer_;
  QueryStats& work_;
  TrianglePairs triangles_;
};

/// Finds the pairs that share no surface vertex, until the answer is full. Distant pairs come
/// first, because neighbours rarely intersect.
void test_separate_triangles(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                             Scratch& scratch, SelfAnswer& answer, QueryStats& work) {
  SeparateTriangles rule(filter, track, answer, work);
  scratch.slot_pairs.clear();
  PairDescent descent(posed, posed, scratch.slot_pairs, rule, work);
  const std::size_t node_count = posed.tree.nodes.size();
  for (std::uint32_t n = 0; n < node_count && !rule.is_full(); ++n) descent.visit_within(n);
  for (std::uint32_t n = 0; n < node_count && !rule.is_full(); ++n) {
    const Node& node = posed.tree.nodes.data()[n];
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot)
      rule.test_neighbours(posed, {posed, node, *posed.opened[n], slot});
  }
  if (!rule.is_full()) rule.flush();
}

Positions copy_positions(const PosedTree& posed, Stack<std::array<float, 4>>& positions) {
  const Node& last = posed.tree.nodes.back();
  positions.reserve(last.first_vertex + last.vertex_count);
  write_positions(posed, positions.begin());
  return positions.begin();
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
  SelfAnswer answer(filter, scratch.found, scratch.ring, max_contacts, stats.left_out);
  test_separate_triangles(posed, filter, track, scratch, answer, stats);
  bool is_unfinished = answer.is_full();
  if (!is_unfinished) {
    const Positions positions =
        track ? track->positions.data() : copy_positions(posed, scratch.positions);
    float* const slack = track ? track->fan_slack.data() : nullptr;
    is_unfinished = test_fans(posed, filter.fans, positions, slack, answer, stats);
  }
  stats.cut_short = answer.cut(is_unfinished);
  return stats;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
