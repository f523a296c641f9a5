#include "geometry/flat_pair.hpp"

#include "exact/predicates.hpp"
#include "geometry/pair_by_signs.hpp"

namespace pelt::detail {

bool has_collapsed(const TriangleCorners& triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [a, b, c] = project(triangle, axis);
    if (orient2d(a, b, c) != 0) return false;
  }
  return true;
}

bool flat_triangles_intersect(const TriangleCorners& a, const TriangleCorners& b) {
  return flat_corners_intersect(a, b);
}

bool segment_meets_triangle(const TriangleCorners& collapsed, const TriangleCorners& triangle) {
  return segment_meets_corners(collapsed, triangle);
}

}  // namespace pelt::detail
