/// Lower bounds of the distances of eight triangle pairs. The nearest points are looked for as in
/// triangle_distance.cpp, but in float and without care; the way d from one to the other is then a
/// direction in which the triangles are as far apart as they are, if it was found. Whatever it is,
/// the gap between the places of their corners along d, divided by |d|, is a lower bound.
///
/// Rounding. Let e = 2^-24, M the largest computed coordinate of a corner relative to a0, and n the
/// computed d / |d|, which is shorter than 1 + 4 e where |d|^2 does not underflow. A corner's place
/// along n is a sum of three products of a difference, with at most 5 errors e each: wrong by less
/// than 3 * 5.1 e M. The gap of two places is wrong by less than 31 e M + 4 e M for n's length and
/// as much as 4 e M for its own rounding; 64 e M covers it. Where |d|^2 could underflow the bound
/// is minus infinity. Places underflow by less than 2^-140 and do not overflow, as M < 2^62.
#include "geometry/triangle_apart.hpp"

#include "geometry/points8.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

/// Into [0, 1]; NaN becomes 1.
Float8 share(const Float8& s) { return max(min(s, Float8(1.0f)), Float8(0.0f)); }

struct Face8 {
  explicit Face8(const Points8 (&t)[3])
      : corner(t), edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]}, normal(cross(edge[0], edge[1])) {
    for (int i = 0; i < 3; ++i) {
      squared_edge[i] = dot(edge[i], edge[i]);
      inverse[i] = Float8(1.0f) / squared_edge[i];
    }
    inverse_normal = Float8(1.0f) / dot(normal, normal);
  }

  const Points8 (&corner)[3];
  Points8 edge[3], normal;
  Float8 squared_edge[3], inverse[3], inverse_normal;
};

/// The shortest way so far from the first triangle to the second.
class Shortest {
 public:
  const Points8& way() const { return way_; }
  const Float8& squared() const { return squared_; }

  void try_edges(const Face8& a, int i, const Face8& b, int j) {
    const Points8 w = a.corner[i] - b.corner[j];
    const Float8 on_u = dot(a.edge[i], w), on_v = dot(b.edge[j], w);
    const Float8 uv = dot(a.edge[i], b.edge[j]);
    const Float8 divisor = a.squared_edge[i] * b.squared_edge[j] - uv * uv;
    const Float8 guess = share((uv * on_v - on_u * b.squared_edge[j]) / divisor);
    const Float8 t = share((uv * guess + on_v) * b.inverse[j]);
    const Float8 s = share((uv * t - on_u) * a.inverse[i]);
    keep(t * b.edge[j] - s * a.edge[i] - w);
  }

  /// From a corner of one triangle to the other's face, where that lies across; `sign` is 1 if the
  /// face is the second triangle's, else -1.
  void try_face(const Points8& corner, const Face8& face, float sign) {
    const Points8 w = corner - face.corner[0];
    const Float8 first = dot(cross(face.edge[0], w), face.normal);
    const Float8 second = dot(cross(face.edge[1], corner - face.corner[1]), face.normal);
    const Float8 third = dot(cross(face.edge[2], corner - face.corner[2]), face.normal);
    const Mask8 is_across = Float8(0.0f) <= min(min(first, second), third);
    keep(Float8(-sign) * dot(w, face.normal) * face.inverse_normal * face.normal, is_across);
  }

 private:
  void keep(const Points8& way) {
    const Float8 squared = dot(way, way);
    take(squared < squared_, squared, way);
  }

  void keep(const Points8& way, const Mask8& where) {
    const Float8 squared = dot(way, way);
    take((squared < squared_) & where, squared, way);
  }

  void take(const Mask8& where, const Float8& squared, const Points8& way) {
    squared_ = select(where, squared, squared_);
    way_ = select(where, way, way_);
  }

  Float8 squared_ = Float8(HUGE_VALF);
  Points8 way_ = {Float8(0.0f), Float8(0.0f), Float8(0.0f)};
};

Float8 largest(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }

/// The gap along a way that need not be the shortest.
Float8 gap_along(const TrianglePairs8& pairs, const Points8& way) {
  const Float8 squared = dot(way, way);
  const Points8 n = (Float8(1.0f) / sqrt(squared)) * way;
  Float8 high(0.0f), low(HUGE_VALF), most(0.0f);
  for (int i = 1; i < 3; ++i) {
    const Points8 p = pairs.a[i] - pairs.a[0];
    high = max(high, dot(n, p));
    most = max(most, largest(p));
  }
  for (const Points8& corner : pairs.b) {
    const Points8 p = corner - pairs.a[0];
    low = min(low, dot(n, p));
    most = max(most, largest(p));
  }
  const Float8 error = Float8(64 * 0x1p-24f) * most + Float8(0x1p-120f);
  return select(Float8(0x1p-80f) < squared, low - high - error, Float8(-HUGE_VALF));
}

}  // namespace

Apart8 how_far_apart(const TrianglePairs8& pairs) {
  const Face8 a(pairs.a), b(pairs.b);
  Shortest shortest;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) shortest.try_edges(a, i, b, j);
  for (int i = 0; i < 3; ++i) {
    shortest.try_face(pairs.a[i], b, 1);
    shortest.try_face(pairs.b[i], a, -1);
  }
  return {gap_along(pairs, shortest.way()), shortest.squared()};
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
