#include "query/find_triangle.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"

namespace pelt::detail {

TriangleCorners corners_at(const Tree& tree, std::uint32_t place, const OpenedNode& opened) {
  TriangleCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = opened.positions + tree.corners[place][k];
    corners[k] = {p[0], p[1], p[2]};
  }
  return corners;
}

FoundTriangle find_triangle(const PosedTree& posed, std::uint32_t id, QueryStats& work) {
  const Tree& tree = posed.tree;
  PELT_ASSERT(id < tree.triangle_count());
  const std::uint32_t place = tree.triangle_places[id], node = node_of_triangle(tree, place);
  return {corners_at(tree, place, open_node(posed, node, work)), node,
          slot_of_triangle(tree, tree.nodes[node], place)};
}

TriangleReader::TriangleReader(const PosedTree& posed) : posed_(posed) { make_table(posed); }

TriangleCorners TriangleReader::corners(std::uint32_t id, QueryStats& work) {
  PELT_ASSERT(id < posed_.tree.triangle_count());
  const std::uint32_t place = posed_.tree.triangle_places[id];
  if (place < places_.first || place >= places_.end) move_to_node_of(place);
  return corners_at(posed_.tree, place, open_node(posed_, node_, work));
}

void TriangleReader::move_to_node_of(std::uint32_t place) {
  const Tree& tree = posed_.tree;
  node_ = node_of_triangle(tree, place);
  places_ = places_of(tree, tree.nodes[node_]);
}

}  // namespace pelt::detail
