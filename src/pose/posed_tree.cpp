#include "pose/posed_tree.hpp"

namespace pelt::detail {

void make_table(const PosedTree& posed) {
  if (posed.opened) return;
  const RootBox root_box = posed.opened.root_box;
  posed.opened = OpenedNodes(static_cast<std::uint32_t>(posed.tree.nodes.size()), posed.arena);
  posed.opened.root_box = root_box;
}

}  // namespace pelt::detail
