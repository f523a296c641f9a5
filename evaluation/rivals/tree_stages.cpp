/// Compiled once for each instruction set.
#include "evaluation/rivals/tree_stages.hpp"

#include "base/instruction_set.hpp"
#include "self/grid_boxes.hpp"
#include "self/self_descent.hpp"

namespace pelt::rivals {
inline namespace PELT_INSTRUCTION_SET {
namespace {

struct CountPairs {
  static bool is_full() { return false; }
  void test(std::uint32_t, std::uint32_t) { ++count; }

  std::uint64_t count = 0;
};

}  // namespace

DescendSelf descend_self;
BoxAllTriangles box_all_triangles;

std::uint64_t descend_self(const detail::PosedTree& posed, const detail::PairMasks& masks) {
  CountPairs rule;
  QueryStats work;
  detail::SelfDescent(posed, masks, rule, work).run();
  return rule.count;
}

void box_all_triangles(const detail::PosedTree& posed, const detail::PairMasks& masks,
                       detail::Scratch& scratch) {
  const detail::GridBoxes boxes(posed, masks.cluster_nodes.data(), scratch.boxes);
  for (std::uint32_t c = 0; c < posed.tree.clusters.size(); ++c) boxes[c];
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::rivals
