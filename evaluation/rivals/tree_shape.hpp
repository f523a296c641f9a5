#pragma once

#include "evaluation/rivals/box_tree.hpp"

namespace pelt::rivals {

/// Lists of vertices contain each vertex once, in ascending order. The last vertex is repeated
/// until the length is a multiple of this, so that loops over the lists have few different lengths,
/// which branch predictors learn.
inline constexpr std::uint32_t kVertexPadding = 4;

/// The constants of a tree of boxes while its triangles move.
struct TreeShape {
  TreeShape(std::span<const Triangle> triangles, std::span<const Vec3> rest,
            std::uint32_t leaf_triangles);

  std::span<const std::uint32_t> vertices_below(std::uint32_t node) const {
    return {vertices.data() + vertices_of[node].begin, vertices.data() + vertices_of[node].end};
  }

  struct Range {
    std::uint32_t begin = 0, end = 0;
  };

  BoxTree tree;                         // over the rest positions
  std::vector<std::uint32_t> vertices;  // lists of each leaf, leaf by leaf
  std::vector<Range> vertices_of;       // by node: of all leaves below it, in `vertices`
};

/// Turns a set of vertices into a list.
void make_vertex_list(std::vector<std::uint32_t>& vertices);

/// Precondition: the length is a multiple of kVertexPadding.
Box4 box_of(std::span<const std::uint32_t> vertices, const Points& points);

/// Computes the boxes of all nodes, children before parents.
void refit_bottom_up(const TreeShape& shape, const Points& points, std::vector<BoxNode>& nodes);

}  // namespace pelt::rivals
