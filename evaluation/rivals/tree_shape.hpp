#pragma once

#include "evaluation/rivals/box_tree.hpp"

namespace pelt::rivals {

/// Lists of vertices have each once, ascending, and the last again until there is a multiple of
/// this many: loops over them then take few different numbers of steps, which branches predict.
inline constexpr std::uint32_t kVertexGroup = 4;

/// What does not change of a tree of boxes while its triangles move.
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
  std::vector<std::uint32_t> vertices;  // lists of each leaf, leaf after leaf
  std::vector<Range> vertices_of;       // by node: of all leaves below it, in `vertices`
};

/// Makes some vertices a list.
void make_vertex_list(std::vector<std::uint32_t>& vertices);

/// Precondition: a multiple of kVertexGroup of them.
Box4 box_of(std::span<const std::uint32_t> vertices, const Points& points);

/// The boxes of all nodes, children before parents.
void refit_bottom_up(const TreeShape& shape, const Points& points, std::vector<BoxNode>& nodes);

}  // namespace pelt::rivals
