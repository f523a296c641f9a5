#pragma once

#include "base/vec3.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>

namespace pelt::detail {

/// The line of all points origin + t * direction. Any finite floats; the direction is a vector.
struct RayLine {
  Vec3 origin, direction;
};

/// How a line goes through a triangle.
struct RayCrossing {
  float t = 0;  ///< the float nearest to the exact parameter, which is finite; never -0
  bool from_front = false;
  std::array<bool, 3> on_edge = {};  ///< whether it meets the edge opposite to each corner
};

/// Whether a line meets a closed triangle, decided exactly on their float32 coordinates; if so,
/// fills `crossing`. A triangle that has collapsed is never met, nor one that the line is parallel
/// to, nor one whose t is beyond all floats.
bool line_meets_triangle(const RayLine& line, const TriangleCorners& triangle,
                         RayCrossing& crossing);

/// The same of a line that is known to meet the triangle away from its edges.
bool line_pierces_triangle(const RayLine& line, const TriangleCorners& triangle, bool from_front,
                           RayCrossing& crossing);

/// On which side of the line the edge from `q` to `r` passes, exactly: the sign of
/// det(direction, q - origin, r - origin), 0 where the line of the edge meets it or is parallel.
int edge_side(const RayLine& line, const Vec3& q, const Vec3& r);

/// The shares of the corners in the place where `line` crosses `triangle`: each within 2^-23 of the
/// exact one, none negative, exactly 0 opposite to an edge that the line meets.
std::array<float, 3> crossing_weights(const RayLine& line, const TriangleCorners& triangle,
                                      const RayCrossing& crossing);

/// The normal, to where the corners are seen counter-clockwise, of twice the triangle's area in
/// length. Each component is within 2^-25 of the longest exact one; all are 0 if the triangle has
/// collapsed.
Vec3d area_vector(const TriangleCorners& triangle);

/// Of length 1 and within 2^-22 of the exact one, to where the corners are seen counter-clockwise.
/// Precondition: the triangle has not collapsed.
Vec3 unit_normal(const TriangleCorners& triangle);

}  // namespace pelt::detail
