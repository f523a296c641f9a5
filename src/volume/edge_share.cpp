#include "volume/edge_share.hpp"

#include "exact/exact_determinant.hpp"

#include <cmath>

namespace pelt::detail {
namespace {

/// det(plane[1] - plane[0], plane[2] - plane[0], point - plane[0]), rounded once.
Rounded exact_height(const TriangleCorners& plane, const Vec3& point) {
  const double value =
      exact_orientation(Vec3d(plane[0]), Vec3d(plane[1]), Vec3d(plane[2]), Vec3d(point));
  return Rounded::within(value, 0x1p-52 * std::abs(value));
}

}  // namespace

Rounded share_before_plane(const Vec3& from, const Vec3& to, const TriangleCorners& plane) {
  using V = Vector<Rounded>;
  const V normal = cross(V(plane[1]) - V(plane[0]), V(plane[2]) - V(plane[0]));
  const Rounded height = dot(normal, V(from) - V(plane[0]));
  const Rounded difference = dot(normal, V(from) - V(to));
  constexpr double kEnough = 0x1p-43;
  if (height.error() + difference.error() < kEnough * std::abs(difference.value()))
    return height / difference;
  const Rounded exact = exact_height(plane, from);
  return exact / (exact - exact_height(plane, to));
}

}  // namespace pelt::detail
