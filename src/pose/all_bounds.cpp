#include "pose/all_bounds.hpp"

#include "pose/open_node.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

QueryStats compute_all_bounds(const PosedTree& posed) {
  QueryStats work;
  root_box(posed, work);
  for (std::uint32_t index = 0; index < posed.tree.nodes.size(); ++index) {
    const OpenedNode& opened = open_node(posed, index, work);
    const Node& node = posed.tree.nodes[index];
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot)
      triangle_boxes(posed, node, opened, slot);
  }
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
