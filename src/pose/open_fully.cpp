#include "pose/open_fully.hpp"

#include "pose/open_node.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

QueryStats open_fully(const PosedTree& posed) {
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

}  // namespace PELT_TARGET
}  // namespace pelt::detail
