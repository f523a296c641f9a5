#include "query/find_triangle.hpp"

#include "base/assert.hpp"
#include "model/triangle_places.hpp"
#include "pose/open_node.hpp"

namespace pelt::detail {

FoundTriangle find_triangle(const PosedTree& posed, std::uint32_t id, QueryStats& work) {
  const Tree& tree = posed.tree;
  PELT_ASSERT(id < tree.triangle_count());
  const std::uint32_t place = tree.triangle_places[id], node = node_of_triangle(tree, place);
  const float* positions = open_node(posed, node, work).positions;
  FoundTriangle found = {{}, node, slot_of_triangle(tree, tree.nodes[node], place)};
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = positions + tree.corners[place][k];
    found.corners[k] = {p[0], p[1], p[2]};
  }
  return found;
}

}  // namespace pelt::detail
