#include "paper/posed_triangles.hpp"

#include <algorithm>

namespace pelt::paper {

PosedTriangles::PosedTriangles(const SkinnedMesh& mesh)
    : mesh_(&mesh), vertex_stamp_(mesh.vertex_count(), 0), positions_(mesh.vertex_count()) {}

void PosedTriangles::invalidate() {
  if (++stamp_ != 0) return;
  std::fill(vertex_stamp_.begin(), vertex_stamp_.end(), 0);
  stamp_ = 1;
}

}  // namespace pelt::paper
