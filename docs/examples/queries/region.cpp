#include <pelt/region.hpp>

bool is_seen(pelt::Pose& pose, const pelt::Matrix4& view_projection, pelt::Scratch& scratch) {
  const pelt::Frustum frustum = pelt::make_frustum(view_projection);
  const pelt::ConvexPolyhedron seen = frustum;
  return pelt::classify(pose, seen, scratch).placement != pelt::Placement::outside;
}

// For a brush tool: the triangles that the brush touches.
std::vector<std::uint32_t> brushed(pelt::Pose& pose, const pelt::Sphere& brush,
                                   pelt::Scratch& scratch) {
  pelt::TrianglesInRegion found;
  pelt::find_triangles(pose, brush, scratch, found);
  return found.touching;
}
