#include "pose/pose_boxes.hpp"
#include "base/float8.hpp"
#include "geometry/box4.hpp"
#include "model/node_box.hpp"
#include "skin/skinned_mesh.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

RootBox box_root(const NodeBounds& bounds, const Palette& palette, const GivenVertices& given) {
  const Box4 box = given ? Box4{load4(given.boxes[0].low), load4(given.boxes[0].high)}
                         : node_box(bounds, 0, palette);
  RootBox root;
  root.known = true;
  store4(root.low, box.low);
  store4(root.high, box.high);
  return root;
}

namespace {

/// Copies the vertices of a range of the pools, and returns their box.
Box4 copy_pool(const Tree& tree, std::span<const Vec3> vertices, std::uint32_t place,
               std::uint32_t end, float* positions) {
  const std::uint32_t* const numbers = tree.place_vertices.data();
  Box4 box = empty_box();
  for (; place < end; ++place) {
    const Vec3& v = vertices[numbers[place]];
    const Float4 p(v.x, v.y, v.z, 0);
    store4(positions + std::size_t{kFloatsPerVertex} * place, p);
    box = unite(box, {p, p});
  }
  return box;
}

}  // namespace

bool are_within(std::span<const Vec3> vertices) {
  const float* const floats = &vertices.data()->x;
  const std::size_t count = 3 * vertices.size(), whole = count / 8 * 8;
  const Float8 most(kMaxCoordinate);
  Mask8 good = Float8(0.0f) <= most;
  for (std::size_t i = 0; i < whole; i += 8) good = good & (abs(load8(floats + i)) <= most);
  for (std::size_t i = whole; i < count; ++i)
    if (!(std::fabs(floats[i]) <= kMaxCoordinate)) return false;
  return good.bits() == 0xFF;
}

GivenVertices refit_given(const Tree& tree, std::span<const Vec3> vertices, Arena& arena) {
  const auto place_count = static_cast<std::uint32_t>(tree.rest_positions.size());
  auto* const positions = reinterpret_cast<float*>(arena.allocate(bytes_of_positions(tree)));
  auto* const boxes = reinterpret_cast<GivenBox*>(arena.allocate(bytes_of_boxes(tree)));
  const Node& last = tree.nodes.back();
  copy_pool(tree, vertices, last.first_vertex + last.vertex_count, place_count, positions);
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const Node& node = tree.nodes[n];
    Box4 box = copy_pool(tree, vertices, node.first_vertex, node.first_vertex + node.vertex_count,
                         positions);
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c)
      box = unite(box, {load4(boxes[c].low), load4(boxes[c].high)});
    store4(boxes[n].low, box.low);
    store4(boxes[n].high, box.high);
  }
  return {positions, boxes};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
