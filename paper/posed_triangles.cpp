#include "paper/posed_triangles.hpp"

namespace pelt::paper {

PosedTriangles::PosedTriangles(const SkinnedMesh& mesh)
    : mesh_(&mesh), vertices_(mesh.vertex_count()), triangles_(mesh.triangle_count()) {}

void PosedTriangles::invalidate() {
  if (++stamp_ != 0) return;
  for (auto& vertex : vertices_) vertex.stamp = 0;
  for (auto& triangle : triangles_) triangle.stamp = 0;
  stamp_ = 1;
}

}  // namespace pelt::paper
