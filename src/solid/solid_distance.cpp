/// The distance from a half-space is that of the triangle's closest corner; from a capsule, that of
/// its segment minus the radius; from a box that does not touch the triangle, that of the closest
/// of its twelve triangles. A segment is treated as a collapsed triangle.

#include "solid/solid_distance.hpp"

#include <pelt/solid.hpp>

#include "base/assert.hpp"
#include "distance/answers.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "solid/prepared_region.hpp"
#include "solid/region_descent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pelt {
namespace detail {
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

namespace {

/// Writes the touching triangles to `scratch.touching`.
QueryStats find_touching(const PosedTree& posed, const PreparedRegion& region, Scratch& scratch) {
  return (region.is_capsule
              ? descend_in_capsule(posed, region.capsule, scratch, RegionGoal::triangles)
              : descend_in_faces(posed, region.faces, scratch, RegionGoal::triangles))
      .work;
}

SolidDistance touching(const PosedTree& posed, const Solid& solid, std::uint32_t triangle,
                       QueryStats& work) {
  make_table(posed);  // bodies wholly inside have not been opened
  const TriangleCorners corners = find_triangle(posed, triangle, work).corners;
  SolidDistance closest;
  closest.distance = 0;
  closest.surface = surface_point(triangle, corners, common_point(corners, solid));
  closest.solid = closest.surface.position;
  return closest;
}

}  // namespace

PreparedSolid::PreparedSolid(const Solid& s)
    : solid(s), region(region_of(s)), extent(extent_of(s)) {}

}  // namespace detail

QueryStats distance(Pose& pose, const Solid& solid, Scratch& scratch, SolidDistance& result,
                    const Limits& limits) {
  detail::require(limits.max_distance >= 0, "distance: the maximum distance is negative or NaN");
  const detail::PosedTree posed = pose.detail().posed_tree();
  const detail::PreparedSolid prepared(solid);
  QueryStats stats = detail::find_touching(posed, prepared.region, scratch.detail());
  if (detail::Stack<std::uint32_t>& found = scratch.detail().touching; !found.empty()) {
    result = detail::touching(posed, solid, *std::min_element(found.begin(), found.end()), stats);
    return stats;
  }
  detail::SolidGap gap;
  stats += detail::closest_to_solid(posed, prepared, scratch.detail(), limits.max_distance, gap);
  result.distance = gap.closest.distance;
  result.surface = detail::surface_point(gap.triangle, gap.corners, gap.closest.at);
  result.solid = detail::to_float(gap.closest.on_solid);
  return stats;
}

}  // namespace pelt
