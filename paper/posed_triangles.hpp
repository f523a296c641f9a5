#pragma once

#include "geometry/triangle_pair.hpp"
#include "pose/skin.hpp"

#include <vector>

namespace pelt::paper {

using detail::Palette;
using detail::SkinnedMesh;
using detail::TriangleCorners;

/// The posed vertices of one pose, skinned when a triangle first needs them and then kept until the
/// palette changes.
class PosedTriangles {
 public:
  explicit PosedTriangles(const SkinnedMesh& mesh);

  /// The palette has changed. O(1).
  void invalidate();

  TriangleCorners corners(std::uint32_t triangle, const Palette& palette) {
    const Triangle& v = mesh_->triangles[triangle];
    return {vertex(v[0], palette), vertex(v[1], palette), vertex(v[2], palette)};
  }

  /// Vertices skinned so far.
  std::uint64_t posed_vertices() const { return posed_vertices_; }

 private:
  const Vec3& vertex(std::uint32_t v, const Palette& palette) {
    if (vertex_stamp_[v] != stamp_) {
      vertex_stamp_[v] = stamp_;
      positions_[v] = detail::posed_vertex(*mesh_, palette, v);
      ++posed_vertices_;
    }
    return positions_[v];
  }

  const SkinnedMesh* mesh_;
  std::uint64_t posed_vertices_ = 0;
  std::uint32_t stamp_ = 1;
  std::vector<std::uint32_t> vertex_stamp_;
  std::vector<Vec3> positions_;
};

}  // namespace pelt::paper
