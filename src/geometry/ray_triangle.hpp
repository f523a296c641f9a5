#pragma once

/// Exact tests of a line and a triangle, and the point in which they meet.

#include "base/vec3.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>

namespace pelt::detail {

/// The line of all points origin + t * direction. All numbers are finite.
struct RayLine {
  Vec3 origin, direction;
};

/// Intersection of a line with a triangle.
struct RayCrossing {
  float t = 0;  ///< the float nearest to the exact parameter, which is finite; never -0
  bool from_front = false;
  std::array<bool, 3> on_edge = {};  ///< whether the line meets the edge opposite to each corner
};

/// Decides exactly whether a line meets a closed triangle with float32 coordinates, and if so fills
/// `crossing`. A line never meets a triangle that has collapsed, that is parallel to the line, or
/// whose t exceeds the range of float.
bool line_meets_triangle(const RayLine& line, const TriangleCorners& triangle,
                         RayCrossing& crossing);

/// Fills `crossing` for a line that is known to meet the triangle away from its edges. Returns
/// false if t exceeds the range of float.
bool line_pierces_triangle(const RayLine& line, const TriangleCorners& triangle, bool from_front,
                           RayCrossing& crossing);

/// Returns exactly on which side of the line the edge from `q` to `r` passes: the sign of
/// det(direction, q - origin, r - origin), which is 0 if the lines meet or are parallel.
int edge_side(const RayLine& line, const Vec3& q, const Vec3& r);

/// Returns the weights of the corners at the point where `line` crosses `triangle`. Each is within
/// 2^-23 of the exact weight, not negative, and exactly 0 opposite to an edge that the line meets.
std::array<float, 3> crossing_weights(const RayLine& line, const TriangleCorners& triangle,
                                      const RayCrossing& crossing);

/// Returns the normal on the side from which the corners appear counter-clockwise. Its length is
/// twice the area of the triangle. The error of each component is below 2^-25 of the largest exact
/// component; all are 0 if the triangle has collapsed.
Vec3d area_vector(const TriangleCorners& triangle);

/// Returns the unit normal on the side from which the corners appear counter-clockwise, within
/// 2^-22 of the exact normal. Precondition: the triangle has not collapsed.
Vec3 unit_normal(const TriangleCorners& triangle);

}  // namespace pelt::detail
