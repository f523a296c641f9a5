#include "pose/posed_tree.hpp"

namespace pelt::detail {

void make_table(const PosedTree& posed) {
  if (posed.opened) return;
  posed.opened = OpenedNodes(static_cast<std::uint32_t>(posed.tree.nodes.size()), posed.arena);
}

std::size_t bytes_to_open(const Tree& tree) {
  constexpr auto piece = Arena::size_of_piece;
  std::size_t bytes = piece(tree.nodes.size() * sizeof(std::atomic<OpenedNode*>)) +
                      tree.nodes.size() * piece(sizeof(OpenedNode)) +
                      tree.clusters.size() * piece(sizeof(TriangleBoxes));
  for (const Node& node : tree.nodes)
    bytes += piece(node.vertex_count * kFloatsPerVertex * sizeof(float));
  return bytes;
}

}  // namespace pelt::detail
