#include "geometry/ray_triage.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

const Float8& on_axis(const Points8& points, int axis) {
  return axis == 0 ? points.x : axis == 1 ? points.y : points.z;
}

/// Corners as the sheared line sees them, and the largest distance on any axis.
struct Seen {
  Float8 x, y, distance;
};

Seen see(const ShearedLine& line, const Points8& corner) {
  const Float8 x = on_axis(corner, line.x) - Float8(line.origin_x);
  const Float8 y = on_axis(corner, line.y) - Float8(line.origin_y);
  const Float8 z = on_axis(corner, line.z) - Float8(line.origin_z);
  return {x - Float8(line.slope_x) * z, y - Float8(line.slope_y) * z,
          max(max(abs(x), abs(y)), abs(z))};
}

Float8 edge(const Seen& p, const Seen& q) { return p.x * q.y - p.y * q.x; }

Float8 largest(const Float8& a, const Float8& b, const Float8& c) { return max(max(a, b), c); }

}  // namespace

ShearedLine shear(const Vec3& origin, const Vec3& direction) {
  const float o[3] = {origin.x, origin.y, origin.z};
  const double d[3] = {direction.x, direction.y, direction.z};
  const auto length = [&](int axis) { return std::fabs(d[axis]); };
  int z = length(1) > length(0) ? 1 : 0;
  if (length(2) > length(z)) z = 2;
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  return {
      x, y, z, o[x], o[y], o[z], static_cast<float>(d[x] / d[z]), static_cast<float>(d[y] / d[z])};
}

unsigned not_missed(const ShearedLine& line, const Points8 (&corners)[3]) {
  const Seen a = see(line, corners[0]), b = see(line, corners[1]), c = see(line, corners[2]);
  const Float8 ab = edge(a, b), bc = edge(b, c), ca = edge(c, a);
  const Float8 distance = largest(a.distance, b.distance, c.distance) * Float8(0x1p-24f);
  const Float8 width =
      max(largest(abs(a.x), abs(b.x), abs(c.x)), largest(abs(a.y), abs(b.y), abs(c.y)));
  const Float8 error =
      Float8(40.0f) * distance * (width + Float8(4.0f) * distance) + Float8(0x1p-84f);
  const Mask8 some_left = error < largest(ab, bc, ca);
  const Mask8 some_right = min(min(ab, bc), ca) < Float8(0.0f) - error;
  return ~(some_left & some_right).bits() & 0xFFu;
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
