#include "geometry/generic_ray.hpp"

#include "exact/predicates.hpp"

namespace pelt::detail {
namespace {

/// The side of an edge that passes through the line along the first direction.
int side_of_turned_ray(const Vec3& origin, const GenericDirection& direction, const Vec3& q,
                       const Vec3& r) {
  const int side = edge_side({origin, direction[1]}, q, r);
  return side != 0 ? side : edge_side({origin, direction[2]}, q, r);
}

}  // namespace

/// The line meets the plane in front of the origin, and not behind it, if and only if it enters the
/// triangle from the side of the origin. Exact signs decide this, because the crossing's t is
/// rounded and may become 0 on either side of the origin.
int pierce_from_back(const Vec3& origin, const GenericDirection& direction,
                     const TriangleCorners& triangle, const RayCrossing& crossing) {
  const int height = orient3d(triangle[0], triangle[1], triangle[2], origin);
  const int side = crossing.from_front ? -1 : 1;
  if (height != -side) return 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (crossing.on_edge[i] &&
        side_of_turned_ray(origin, direction, triangle[(i + 1) % 3], triangle[(i + 2) % 3]) != side)
      return 0;
  return side;
}

}  // namespace pelt::detail
