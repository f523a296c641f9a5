#include "evaluation/rivals/tree_shape.hpp"

#include <algorithm>

namespace pelt::rivals {
namespace {

/// The list of the vertices of a set of triangles.
std::vector<std::uint32_t> corners_of(std::span<const Triangle> all,
                                      std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t t : triangles)
    corners.insert(corners.end(), all[t].begin(), all[t].end());
  make_vertex_list(corners);
  return corners;
}

/// The leaves, ordered by their triangles.
std::vector<std::uint32_t> leaves_of(const BoxTree& tree) {
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    if (tree.nodes[n].count > 0) leaves.push_back(n);
  std::sort(leaves.begin(), leaves.end(), [&](std::uint32_t a, std::uint32_t b) {
    return tree.nodes[a].first < tree.nodes[b].first;
  });
  return leaves;
}

}  // namespace

TreeShape::TreeShape(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                     std::uint32_t leaf_triangles)
    : tree(build_box_tree(triangles, Points(rest), leaf_triangles)),
      vertices_of(tree.nodes.size()) {
  for (const std::uint32_t n : leaves_of(tree)) {
    const BoxNode& leaf = tree.nodes[n];
    const auto corners = corners_of(triangles, {tree.order.data() + leaf.first, leaf.count});
    const auto begin = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    vertices_of[n] = {begin, static_cast<std::uint32_t>(vertices.size())};
  }
  for (std::size_t n = tree.nodes.size(); n-- > 0;)
    if (const BoxNode& node = tree.nodes[n]; node.count == 0)
      vertices_of[n] = {vertices_of[node.first].begin, vertices_of[node.first + 1].end};
}

void make_vertex_list(std::vector<std::uint32_t>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  while (vertices.size() % kVertexPadding != 0) vertices.push_back(vertices.back());
}

Box4 box_of(std::span<const std::uint32_t> vertices, const Points& points) {
  Box4 box = detail::empty_box();
  for (std::size_t i = 0; i < vertices.size(); i += kVertexPadding) {
    const Float4 a = points[vertices[i]], b = points[vertices[i + 1]];
    const Float4 c = points[vertices[i + 2]], d = points[vertices[i + 3]];
    box = unite(box, {min(min(a, b), min(c, d)), max(max(a, b), max(c, d))});
  }
  return box;
}

void refit_bottom_up(const TreeShape& shape, const Points& points, std::vector<BoxNode>& nodes) {
  for (std::size_t n = nodes.size(); n-- > 0;) {
    BoxNode& node = nodes[n];
    node.set_box(node.count == 0
                     ? unite(nodes[node.first].box(), nodes[node.first + 1].box())
                     : box_of(shape.vertices_below(static_cast<std::uint32_t>(n)), points));
  }
}

}  // namespace pelt::rivals
