/// Compiled once for each instruction set.
#include "evaluation/rivals/tree_stages.hpp"

#include "base/instruction_set.hpp"
#include "self/grid_boxes.hpp"
#include "self/self_descent.hpp"

namespace pelt::rivals {
inline namespace PELT_INSTRUCTION_SET {
namespace {

struct CountPairs {
  explicit CountPairs(const detail::PosedTree& p) : posed(p) {}

  static bool is_full() { return false; }

  detail::SlotMatrix overlapping_slots(std::uint32_t a, std::uint32_t b) const {
    const detail::OpenedNode &opened_a = *posed.opened[a], &opened_b = *posed.opened[b];
    detail::SlotMatrix matrix = 0;
    for (unsigned row = 0; row < detail::kMaxSlots; ++row)
      matrix |= detail::SlotMatrix{detail::slots_in(
                    opened_b, detail::lane_box(opened_a.low, opened_a.high, row))}
                << 8 * row;
    return matrix;
  }

  void test(std::uint32_t, std::uint32_t) { ++count; }

  const detail::PosedTree& posed;
  std::uint64_t count = 0;
};

}  // namespace

DescendSelf descend_self;
BoxAllTriangles box_all_triangles;

std::uint64_t descend_self(const detail::PosedTree& posed, const detail::PairMasks& masks) {
  CountPairs rule(posed);
  QueryStats work;
  detail::SelfDescent(posed.tree, masks, rule, work).run();
  return rule.count;
}

void box_all_triangles(const detail::PosedTree& posed, const detail::PairMasks& masks,
                       detail::Scratch& scratch) {
  const detail::GridBoxes boxes(posed, masks.cluster_nodes.data(), scratch.boxes);
  for (std::uint32_t c = 0; c < posed.tree.clusters.size(); ++c) boxes[c];
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::rivals
