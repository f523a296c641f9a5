#include "pose/posed_tree.hpp"

#include <algorithm>
#include <limits>

namespace pelt::detail {

void make_table(const PosedTree& posed) {
  if (posed.opened) return;
  posed.opened = OpenedNodes(static_cast<std::uint32_t>(posed.tree.nodes.size()), posed.arena);
}

/// Limited to what no machine has, because the sum can be larger than a 32-bit std::size_t.
std::size_t bytes_to_open(const Tree& tree) {
  constexpr std::uint64_t kMax = std::numeric_limits<std::ptrdiff_t>::max();
  constexpr auto piece = Arena::size_of_piece;
  std::uint64_t bytes = piece(tree.nodes.size() * sizeof(std::atomic<OpenedNode*>));
  bytes += std::uint64_t{tree.nodes.size()} * piece(sizeof(OpenedNode));
  bytes += std::uint64_t{tree.clusters.size()} * piece(sizeof(TriangleBoxes));
  std::uint64_t positions = 0;
  for (const Node& node : tree.nodes)
    positions += piece(std::size_t{node.vertex_count} * kFloatsPerVertex * sizeof(float));
  bytes += std::max<std::uint64_t>(positions,
                                   piece(bytes_of_positions(tree)) + piece(bytes_of_boxes(tree)));
  return static_cast<std::size_t>(std::min(bytes, kMax));
}

}  // namespace pelt::detail
