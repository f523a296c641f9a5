#pragma once

/// A binary tree of axis-aligned boxes, built top-down by the surface area heuristic (Goldsmith &
/// Salmon 1987) over bins (Wald 2007, "On fast construction of SAH-based bounding volume
/// hierarchies").

#include <pelt/mesh.hpp>

#include "geometry/box4.hpp"

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace pelt::rivals {

using detail::Box4;
using detail::Float4;

/// Posed vertices, four floats at a time.
class Points {
 public:
  Points() = default;
  explicit Points(std::span<const Vec3> positions)
      : positions_(positions.data()), last_(static_cast<std::uint32_t>(positions.size() - 1)) {}

  /// Lanes x, y, z; lane 3 is meaningless.
  Float4 operator[](std::uint32_t v) const {
    const Vec3& p = positions_[v];
    return v < last_ ? detail::load4(&p.x) : Float4(p.x, p.y, p.z, 0);
  }

  Box4 box_of(const Triangle& triangle) const {
    const Points& p = *this;
    const Float4 a = p[triangle[0]], b = p[triangle[1]], c = p[triangle[2]];
    return {min(min(a, b), c), max(max(a, b), c)};
  }

  const Vec3* data() const { return positions_; }

 private:
  const Vec3* positions_ = nullptr;
  std::uint32_t last_ = 0;
};

/// The box of the first `count` points.
inline Box4 box_of(const Points& points, std::uint32_t count) {
  Box4 box = detail::empty_box();
  for (std::uint32_t v = 0; v < count; ++v)
    box = {min(box.low, points[v]), max(box.high, points[v])};
  return box;
}

/// Boxes that touch overlap.
inline bool overlap(const Box4& a, const Box4& b) {
  constexpr unsigned kThreeLanes = 7;
  return ((a.low <= b.high) & (b.low <= a.high)).bits() % 8 == kThreeLanes;
}

/// A box and two numbers in half a cache line.
struct alignas(32) NumberedBox {
  float low[3];
  std::uint32_t first;
  float high[3];
  std::uint32_t count;

  Box4 box() const {
    Box4 box;  // the numbers are stored in its unused lanes
    std::memcpy(&box.low, this, sizeof box.low);
    std::memcpy(&box.high, reinterpret_cast<const char*>(this) + 16, sizeof box.high);
    return box;
  }

  void set_box(const Box4& box) {
    const std::uint32_t numbers[] = {first, count};
    std::memcpy(static_cast<void*>(this), &box.low, sizeof box.low);
    std::memcpy(reinterpret_cast<char*>(this) + 16, &box.high, sizeof box.high);
    first = numbers[0], count = numbers[1];
  }
};

/// A node. A leaf has the triangles [first, first + count) in the tree's order. For an inner node,
/// count is 0 and the children are first and first + 1.
using BoxNode = NumberedBox;

inline constexpr std::uint32_t kMaxLeafTriangles = 32;

/// Breadth-first: the root is node 0, children follow their parents, and siblings are adjacent.
struct BoxTree {
  std::vector<BoxNode> nodes;
  std::vector<std::uint32_t> order;  // [T] triangles; those of a leaf are contiguous
};

/// Builds a tree whose leaves have at most `leaf_triangles`. O(T log T), except for boxes that are
/// made to prevent it. Precondition: there is at least one triangle, and 1 <= leaf_triangles <=
/// kMaxLeafTriangles.
BoxTree build_box_tree(std::span<const Triangle> triangles, const Points& points,
                       std::uint32_t leaf_triangles);

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

/// Data that is prepared once for all bodies of a mesh. Bodies with the same array of triangles
/// share it.
template <typename Shape>
class SharedShapes {
 public:
  explicit SharedShapes(std::uint32_t leaf_triangles) : leaf_triangles_(leaf_triangles) {}

  /// The largest number of triangles of a leaf.
  std::uint32_t leaf_triangles() const { return leaf_triangles_; }

  const Shape& of(std::span<const Triangle> triangles, std::span<const Vec3> rest) {
    std::unique_ptr<Shape>& shape = shapes_[triangles.data()];
    if (!shape) shape = std::make_unique<Shape>(triangles, rest, leaf_triangles_);
    return *shape;
  }

 private:
  std::uint32_t leaf_triangles_;
  std::map<const Triangle*, std::unique_ptr<Shape>> shapes_;
};

}  // namespace pelt::rivals
