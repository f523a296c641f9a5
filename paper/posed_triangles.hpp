#pragma once

#include "geometry/triangle_pair.hpp"
#include "paper/prefetch.hpp"
#include "paper/sphere_tree.hpp"
#include "skin/skin.hpp"

#include <vector>

namespace pelt::paper {

using detail::Palette;
using detail::TriangleCorners;

/// The posed triangles of one pose, in the order of the sphere tree's leaves, like those of the
/// mesh (leaf_order.hpp): triangles that are used together are neighbours in memory. Vertices are
/// skinned when a triangle first needs them. Vertices and triangles stay valid until the palette
/// changes.
class PosedTriangles {
 public:
  explicit PosedTriangles(const SkinnedMesh& mesh_in_leaf_order);

  /// Call after the palette has changed. O(1).
  void invalidate();

  const TriangleCorners& corners(const Node& leaf, const Palette& palette) {
    Stamped<TriangleCorners>& posed = triangles_[leaf.first_triangle];
    if (posed.stamp != stamp_) {
      const Triangle& v = mesh_->triangles[leaf.first_triangle];
      posed = {{vertex(v[0], palette), vertex(v[1], palette), vertex(v[2], palette)}, stamp_};
    }
    return posed.value;
  }

  /// Call some time before corners().
  void prefetch(const Node& node) const {
    paper::prefetch(&triangles_[node.first_triangle]);
    paper::prefetch(&mesh_->triangles[node.first_triangle]);
  }

  /// Vertices skinned so far.
  std::uint64_t posed_vertices() const { return posed_vertices_; }

 private:
  template <typename T>
  struct Stamped {
    T value;
    std::uint32_t stamp = 0;
  };

  const Vec3& vertex(std::uint32_t v, const Palette& palette) {
    Stamped<Vec3>& posed = vertices_[v];
    if (posed.stamp != stamp_) {
      posed = {detail::posed_vertex(*mesh_, palette, v), stamp_};
      ++posed_vertices_;
    }
    return posed.value;
  }

  const SkinnedMesh* mesh_;
  std::uint64_t posed_vertices_ = 0;
  std::uint32_t stamp_ = 1;
  std::vector<Stamped<Vec3>> vertices_;              // [V]
  std::vector<Stamped<TriangleCorners>> triangles_;  // [T], in the order of the leaves
};

}  // namespace pelt::paper
