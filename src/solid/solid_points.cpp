/// The distance from a half-space is that of the triangle's closest corner; from a capsule, that of
/// its segment minus the radius; from a box that does not touch the triangle, that of the closest
/// of its twelve triangles. A segment is treated as a collapsed triangle.

#include "solid/solid_points.hpp"

#include "solid/prepared_region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pelt::detail {
namespace {

constexpr double kLeast = std::numeric_limits<double>::min();

Barycentrics at_corner(std::size_t corner) {
  Barycentrics at = {};
  at[corner] = 1;
  return at;
}

// Half-spaces.

double height_over(const HalfSpace& half, const Vec3& p) {
  return dot(Vec3d(half.normal), Vec3d(p)) - double{half.offset};
}

std::size_t lowest_corner(const TriangleCorners& triangle, const HalfSpace& half) {
  std::size_t lowest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (height_over(half, triangle[k]) < height_over(half, triangle[lowest])) lowest = k;
  return lowest;
}

SolidPoints closest(const TriangleCorners& triangle, const HalfSpace& half) {
  const std::size_t corner = lowest_corner(triangle, half);
  const double length = std::sqrt(squared_length(Vec3d(half.normal)));
  const double distance = height_over(half, triangle[corner]) / length;
  const Vec3d way = (-distance / length) * Vec3d(half.normal);
  return {distance, at_corner(corner), Vec3d(triangle[corner]) + way};
}

Barycentrics common(const TriangleCorners& triangle, const HalfSpace& half) {
  return at_corner(lowest_corner(triangle, half));
}

// Capsules.

SolidPoints closest(const TriangleCorners& triangle, const Capsule& capsule) {
  const TriangleCorners segment = {capsule.a, capsule.b, capsule.b};
  const ClosestPoints points = closest_points(triangle, segment);
  const double to_segment = std::sqrt(points.squared_distance);
  const Vec3d axis = point_at(segment, points.b);
  const Vec3d way = point_at(triangle, points.a) - axis;
  return {to_segment - double{capsule.radius}, points.a,
          axis + (double{capsule.radius} / to_segment) * way};
}

Barycentrics common(const TriangleCorners& triangle, const Capsule& capsule) {
  return common_point(triangle, TriangleCorners{capsule.a, capsule.b, capsule.b}).a;
}

SolidPoints closest(const TriangleCorners& triangle, const Sphere& sphere) {
  return closest(triangle, Capsule{sphere.centre, sphere.centre, sphere.radius});
}

Barycentrics common(const TriangleCorners& triangle, const Sphere& sphere) {
  return common(triangle, Capsule{sphere.centre, sphere.centre, sphere.radius});
}

// Boxes.

/// Corner k is on the high side of axis i if bit i of k is set.
using BoxCorners = std::array<Vec3, 8>;

/// Returns the triangles of a box's surface.
std::array<TriangleCorners, 12> triangles_of(const BoxCorners& corners) {
  std::array<TriangleCorners, 12> triangles;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t axis = i / 2, side = (i % 2) << axis;
    const std::size_t u = std::size_t{1} << (axis + 1) % 3, v = std::size_t{1} << (axis + 2) % 3;
    const Vec3 &first = corners[side], &last = corners[side | u | v];
    triangles[2 * i] = {first, corners[side | u], last};
    triangles[2 * i + 1] = {first, last, corners[side | v]};
  }
  return triangles;
}

BoxCorners corners_of(const Box& box) {
  BoxCorners corners;
  for (std::size_t k = 0; k < 8; ++k)
    corners[k] = {k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                  k & 4 ? box.high.z : box.low.z};
  return corners;
}

/// Returns the corners, where the axes have given values, as combinations of the axes' cross
/// products.
BoxCorners corners_of(const OrientedBox& box) {
  const Vec3d a(box.axes[0]), b(box.axes[1]), c(box.axes[2]), centre(box.centre);
  const Vec3d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double volume = dot(a, bc);
  BoxCorners corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const double x = k & 1 ? box.half.x : -box.half.x, y = k & 2 ? box.half.y : -box.half.y,
                 z = k & 4 ? box.half.z : -box.half.z;
    corners[k] = to_float(centre + (1 / volume) * (x * bc + y * ca + z * ab));
  }
  return corners;
}

template <typename AnyBox>
SolidPoints closest(const TriangleCorners& triangle, const AnyBox& box) {
  SolidPoints best;
  for (const TriangleCorners& face : triangles_of(corners_of(box))) {
    const ClosestPoints points = closest_points(triangle, face);
    const double distance = std::sqrt(points.squared_distance);
    if (distance < best.distance) best = {distance, points.a, point_at(face, points.b)};
  }
  return best;
}

/// A touching triangle that is not inside intersects the box's surface.
template <typename AnyBox>
Barycentrics common(const TriangleCorners& triangle, const AnyBox& box) {
  if (place_in(PreparedRegion(box).faces, triangle) == TrianglePlace::inside) return at_corner(0);
  ClosestPoints best = {std::numeric_limits<double>::infinity(), {1, 0, 0}, {1, 0, 0}};
  for (const TriangleCorners& face : triangles_of(corners_of(box))) {
    const ClosestPoints points = common_point(triangle, face);
    if (points.squared_distance < best.squared_distance) best = points;
  }
  return best.a;
}

// Extents.

double largest(const Vec3& v) {
  return std::max({std::abs(double{v.x}), std::abs(double{v.y}), std::abs(double{v.z})});
}

double extent(const HalfSpace& half) {
  return std::abs(double{half.offset}) / std::sqrt(squared_length(Vec3d(half.normal)));
}

double extent(const Capsule& capsule) {
  return std::max(largest(capsule.a), largest(capsule.b)) + double{capsule.radius};
}

double extent(const Sphere& sphere) { return largest(sphere.centre) + double{sphere.radius}; }

double extent(const Box& box) { return std::max(largest(box.low), largest(box.high)); }

double extent(const OrientedBox& box) {
  double most = 0;
  for (const Vec3& corner : corners_of(box)) most = std::max(most, largest(corner));
  return 0x1p24 * most;
}

}  // namespace

SolidPoints closest_points(const TriangleCorners& triangle, const Solid& solid) {
  SolidPoints points =
      std::visit([&](const auto& shape) { return closest(triangle, shape); }, solid);
  if (points.distance < kLeast) points.distance = kLeast;
  return points;
}

Barycentrics common_point(const TriangleCorners& triangle, const Solid& solid) {
  return std::visit([&](const auto& shape) { return common(triangle, shape); }, solid);
}

double extent_of(const Solid& solid) {
  return std::visit([](const auto& shape) { return extent(shape); }, solid);
}

}  // namespace pelt::detail
