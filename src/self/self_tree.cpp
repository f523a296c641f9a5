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
#include "self/self_answer.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters that share no surface vertex.
class SeparateTriangles : public BoxOverlap {
 public:
  SeparateTriangles(const SelfFilter& filter, SelfAnswer& answer, QueryStats& work)
      : filter_(filter),
        answer_(answer),
        triangles_(filter.tree(), filter.tree(), answer.contacts(), work) {}

  bool is_full() const { return answer_.is_full(); }
  bool is_impatient() const { return answer_.is_impatient(); }

  void test(const PosedCluster& a, const PosedCluster& b) {
    const std::uint32_t in_a = a.node.first_cluster + a.slot, in_b = b.node.first_cluster + b.slot;
    in_a <= in_b ? add(a, in_a, b, in_b) : add(b, in_b, a, in_a);
    if (is_impatient()) triangles_.flush();
    answer_.settle();
  }

  void flush() {
    triangles_.flush();
    answer_.settle();
  }

 private:
  void add(const PosedCluster& a, std::uint32_t low, const PosedCluster& b, std::uint32_t high) {
    const PairMasks& masks = filter_.masks;
    if (masks.has_hub.data()[low] & masks.has_hub.data()[high]) {
      PairMask mask;
      masks.write_mask(filter_.tree(), filter_.fans, low, high, mask);
      triangles_.add(a, b, mask.rows);
    } else if (const PairMask* mask = masks.find(low, high)) {
      triangles_.add(a, b, mask->rows);
    } else {
      triangles_.add(a, b);
    }
  }

  const SelfFilter& filter_;
  SelfAnswer& answer_;
  TrianglePairs triangles_;
};

/// Finds the pairs that share no surface vertex, until the answer is full.
void test_separate_triangles(const PosedTree& posed, const SelfFilter& filter, Scratch& scratch,
                             SelfAnswer& answer, QueryStats& work) {
  SeparateTriangles rule(filter, answer, work);
  scratch.slot_pairs.clear();
  PairDescent descent(posed, posed, scratch.slot_pairs, rule, work);
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n) {
    const Node& node = posed.tree.nodes.data()[n];
    const OpenedNode& opened = *posed.opened[n];
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot) {
      const PosedCluster cluster = {posed, node, opened, slot};
      rule.test(cluster, cluster);
    }
    descent.visit_within(n);
    if (rule.is_full()) return;
  }
  rule.flush();
}

/// Copies the posed vertices of all pools to one array, by place.
Positions copy_positions(const PosedTree& posed, Stack<std::array<float, 4>>& positions) {
  const Node& last = posed.tree.nodes.back();
  const std::size_t count = last.first_vertex + last.vertex_count;
  positions.reserve(count);
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n) {
    const Node& node = posed.tree.nodes.data()[n];
    const float* from = posed.opened[n]->positions;
    for (std::uint32_t v = 0; v < node.vertex_count; ++v)
      store4(positions.begin()[node.first_vertex + v].data(), load4(from + 4 * v));
  }
  return positions.begin();
}

}  // namespace

SelfStats self_collide_tree(const PosedTree& posed, const SelfFilter& filter, Scratch& scratch,
                            std::uint32_t max_contacts) {
  SelfStats stats;
  scratch.found.clear();
  make_table(posed);
  stats += open_all(posed);
  SelfAnswer answer(filter, scratch.found, scratch.ring, max_contacts, stats.left_out);
  test_separate_triangles(posed, filter, scratch, answer, stats);
  bool is_unfinished = answer.is_full();
  if (!is_unfinished) {
    const Positions positions = copy_positions(posed, scratch.positions);
    is_unfinished = test_fans(posed, filter.fans, positions, answer, stats);
  }
  stats.cut_short = answer.cut(is_unfinished);
  return stats;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
