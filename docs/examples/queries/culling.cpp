#include <pelt/solid.hpp>

bool is_seen(pelt::Pose& pose, const pelt::Matrix4& view_projection, pelt::Scratch& scratch) {
  const pelt::Region seen = pelt::make_frustum(view_projection);
  return bool(pelt::intersects(pose, seen, scratch));
}

// For a brush tool: the triangles that the brush touches.
std::vector<std::uint32_t> brushed(pelt::Pose& pose, const pelt::Sphere& brush,
                                   pelt::Scratch& scratch) {
  pelt::TrianglesInRegion found;
  pelt::find_triangles(pose, brush, scratch, found);
  return found.intersecting;
}
