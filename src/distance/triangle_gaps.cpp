#include "distance/triangle_gaps.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Returns one corner of each of the eight triangles starting at `first`.
Points8 corner8(const PosedCluster& cluster, std::uint32_t first, std::size_t corner) {
  const auto* corners = cluster.posed.tree.corners.data() + cluster.cluster().first_triangle;
  const std::uint32_t last = cluster.cluster().triangle_count - 1u;
  const auto at = [&](std::uint32_t lane) {
    const std::uint32_t triangle = first + lane < last ? first + lane : last;
    return load4(cluster.opened.positions + corners[triangle][corner]);
  };
  return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
}

Float8 place(const Points8& p, const Vec3& direction, const Vec3& origin) {
  return (p.x - Float8(origin.x)) * Float8(direction.x) +
         (p.y - Float8(origin.y)) * Float8(direction.y) +
         (p.z - Float8(origin.z)) * Float8(direction.z);
}

/// Applies `choose` to the values of each triangle's corners.
template <typename Choose>
TriangleValues places(const PosedCluster& cluster, const Vec3& direction, const Vec3& origin,
                      const Choose& choose) {
  TriangleValues values;
  for (std::uint32_t first = 0; first < kMaxClusterTriangles; first += 8) {
    const Float8 a = place(corner8(cluster, first, 0), direction, origin);
    const Float8 b = place(corner8(cluster, first, 1), direction, origin);
    const Float8 c = place(corner8(cluster, first, 2), direction, origin);
    choose(choose(a, b), c).store(values.of + first);
  }
  return values;
}

/// Twice the middle of the cluster's box on an axis.
double middle(const PosedCluster& cluster, int axis) {
  return double{cluster.opened.low[axis][cluster.slot]} + cluster.opened.high[axis][cluster.slot];
}

}  // namespace

TriangleValues Along::lowest(const PosedCluster& cluster) const {
  return places(cluster, direction_, origin_,
                [](const Float8& x, const Float8& y) { return min(x, y); });
}

TriangleValues Along::highest(const PosedCluster& cluster) const {
  return places(cluster, direction_, origin_,
                [](const Float8& x, const Float8& y) { return max(x, y); });
}

std::uint32_t lowest_of(const TriangleValues& values) {
  std::uint32_t lowest = 0;
  for (std::uint32_t i = 1; i < kMaxClusterTriangles; ++i)
    if (values.of[i] < values.of[lowest]) lowest = i;
  return lowest;
}

std::uint32_t highest_of(const TriangleValues& values) {
  std::uint32_t highest = 0;
  for (std::uint32_t i = 1; i < kMaxClusterTriangles; ++i)
    if (values.of[i] > values.of[highest]) highest = i;
  return highest;
}

unsigned up_to(const TriangleValues& values, float most) {
  const Float8 limit(most);
  return (load8(values.of) <= limit).bits() | (load8(values.of + 8) <= limit).bits() << 8;
}

TriangleCorners corners_of(const PosedCluster& cluster, std::uint32_t place) {
  TriangleCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = cluster.opened.positions + cluster.posed.tree.corners.data()[place][k];
    corners[k] = {p[0], p[1], p[2]};
  }
  return corners;
}

float gap_error(const PosedCluster& a, const PosedCluster& b, const Vec3& origin) {
  const float from[3] = {origin.x, origin.y, origin.z};
  float most = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const PosedCluster* cluster : {&a, &b}) {
      const float low = std::fabs(cluster->opened.low[axis][cluster->slot] - from[axis]);
      const float high = std::fabs(cluster->opened.high[axis][cluster->slot] - from[axis]);
      const float larger = low > high ? low : high;
      most = larger > most ? larger : most;
    }
  return 48 * 0x1p-24f * most + 0x1p-120f;
}

Vec3 low_corner(const PosedCluster& cluster) {
  return {cluster.opened.low[0][cluster.slot], cluster.opened.low[1][cluster.slot],
          cluster.opened.low[2][cluster.slot]};
}

Vec3 direction_between(const PosedCluster& a, const PosedCluster& b) {
  return direction_of(
      {middle(b, 0) - middle(a, 0), middle(b, 1) - middle(a, 1), middle(b, 2) - middle(a, 2)});
}

Vec3 direction_of(const Vec3d& way) {
  const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  if (!(length > 0)) return {};
  return {static_cast<float>(way.x / length), static_cast<float>(way.y / length),
          static_cast<float>(way.z / length)};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
