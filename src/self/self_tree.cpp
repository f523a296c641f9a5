/// A tree against itself. Neighbouring triangles always touch, so every node would be opened: all
/// nodes are opened at once, bottom-up, which is cheaper. Pairs of triangles that share no surface
/// vertex are found by a descent, which skips the others by their masks (pair_masks.hpp). Pairs
/// that share one are found fan by fan (fan_pairs.hpp).

#include "self/self_tree.hpp"

#include "pose/open_node.hpp"
#include "query/contact_sink.hpp"
#include "self/cluster_pairs.hpp"
#include "self/fan_pairs.hpp"
#include "self/grid_boxes.hpp"
#include "self/neighbour_gaps.hpp"
#include "self/self_answer.hpp"
#include "self/self_descent.hpp"
#include "self/slack.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters that share no surface vertex.
class SeparateTriangles {
 public:
  SeparateTriangles(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                    Arena& memory, SelfAnswer& answer, QueryStats& work)
      : filter_(filter),
        track_(track),
        answer_(answer),
        work_(work),
        triangles_(posed.tree, posed.tree, answer.contacts(), work),
        pairs_(posed, filter.masks.cluster_nodes.data(), memory, triangles_) {}

  bool is_full() const { return answer_.is_full(); }
  bool is_impatient() const { return answer_.is_impatient(); }

  /// Tests two clusters that are no neighbours.
  void test(std::uint32_t low, std::uint32_t high) {
    if (has_hubs(low, high))
      test_hubs(low, high);
    else
      pairs_.add(low, high, kNoneSkipped.rows);
    settle();
  }

  /// Tests a cluster against itself and against the neighbours with higher numbers.
  void test_neighbours(std::uint32_t low) {
    const PairMasks& masks = filter_.masks;
    for (std::uint32_t i = masks.begin.data()[low]; i < masks.begin.data()[low + 1]; ++i) {
      if (track_ && track_->pair_slack.data()[i] > 0) continue;
      test_neighbour(i, low, masks.others.data()[i]);
      settle();
      if (is_full()) return;
    }
  }

  void flush() {
    pairs_.flush();
    triangles_.flush();
    answer_.settle();
  }

 private:
  void settle() {
    if (is_impatient()) flush();
    answer_.settle();
  }

  bool has_hubs(std::uint32_t low, std::uint32_t high) const {
    const std::uint8_t* const has_hub = filter_.masks.has_hub.data();
    return has_hub[low] & has_hub[high];
  }

  void test_neighbour(std::uint32_t mask, std::uint32_t low, std::uint32_t high) {
    const PairMask& skipped = filter_.masks.masks.data()[mask];
    if (has_hubs(low, high))
      test_hubs(low, high);
    else if (track_ && track_->may_gain(mask))
      track_->set_slack(low, mask,
                        test_gaps(pairs_.cluster(low), pairs_.cluster(high), skipped.rows,
                                  track_->extent, triangles_, work_));
    else
      pairs_.add(low, high, skipped.rows);
  }

  void test_hubs(std::uint32_t low, std::uint32_t high) {
    PairMask mask;
    filter_.masks.write_mask(filter_.tree(), filter_.fans, low, high, mask);
    pairs_.add(low, high, mask.rows);
    pairs_.flush();
  }

  static constexpr PairMask kNoneSkipped = {};

  const SelfFilter& filter_;
  SelfTrack* track_;  // or null
  SelfAnswer& answer_;
  QueryStats& work_;
  TrianglePairs triangles_;
  ClusterPairs pairs_;
};

/// Finds the pairs that share no surface vertex, until the answer is full. Distant pairs come
/// first, because neighbours rarely intersect.
void test_separate_triangles(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                             Scratch& scratch, SelfAnswer& answer, QueryStats& work) {
  SeparateTriangles rule(posed, filter, track, scratch.boxes, answer, work);
  SelfDescent(posed, filter.masks, rule, work).run();
  const std::size_t cluster_count = posed.tree.clusters.size();
  for (std::uint32_t c = 0; c < cluster_count && !rule.is_full(); ++c) rule.test_neighbours(c);
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
