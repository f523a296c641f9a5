/// Compiled once for each instruction set.
#include "evaluation/rivals/tree_stages.hpp"

#include "base/instruction_set.hpp"
#include "pose/open_node.hpp"
#include "query/box_overlap.hpp"
#include "query/pair_descent.hpp"

namespace pelt::rivals {
inline namespace PELT_INSTRUCTION_SET {
namespace {

using detail::PosedCluster;

struct CountClusters : detail::BoxOverlap {
  static bool is_full() { return false; }
  static bool is_impatient() { return false; }
  void test(const PosedCluster&, const PosedCluster&) { ++count; }

  std::uint64_t count = 0;
};

}  // namespace

DescendSelf descend_self;
BoxAllTriangles box_all_triangles;

std::uint64_t descend_self(const detail::PosedTree& posed, detail::Scratch& scratch) {
  CountClusters rule;
  QueryStats work;
  scratch.slot_pairs.clear();
  detail::PairDescent descent(posed, posed, scratch.slot_pairs, rule, work);
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n) descent.visit_within(n);
  return rule.count;
}

void box_all_triangles(const detail::PosedTree& posed) {
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n) {
    const detail::Node& node = posed.tree.nodes[n];
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot)
      detail::triangle_boxes(posed, node, *posed.opened[n], slot);
  }
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::rivals
