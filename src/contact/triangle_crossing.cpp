/// The intersection of two triangles as a segment between features. As in triangle_pair.cpp, two
/// triangles whose planes cross in a line L cut L in two intervals, and L has the direction D = n_a
/// x n_b. The two ends of an interval are distinguished by the direction in which the triangle's
/// outline, in the order of its vertices, passes the other's plane. If the outline passes in the
/// direction w, the triangle is on the side n x w of the end, and
///   (n_a x w) . D = |n_a|^2 (w . n_b),   (n_b x w) . D = -|n_b|^2 (w . n_a),
/// so a's interval begins where its outline comes to the front of b's plane, and b's interval where
/// its outline goes behind a's plane. The order of two ends along L, one of each triangle, is the
/// orientation of two lines through the ends that go from the front of the other's plane to its
/// back (proof in triangle_pair.cpp).

#include "contact/triangle_crossing.hpp"

#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "exact/exact_determinant.hpp"
#include "exact/predicates.hpp"
#include "geometry/pair_by_signs.hpp"
#include "geometry/triangle_pair.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pelt::detail {
namespace {

/// An end of a triangle's interval, on a directed line that goes from the front of the other's
/// plane to its back.
struct IntervalEnd {
  OpenFeature feature = OpenFeature::face;
  const Vec3 *front = nullptr, *back = nullptr;
};

/// The end at a corner on the plane; the corner `other` is not on the plane.
IntervalEnd end_in_corner(const TriangleCorners& t, const PlaneSides& s, std::size_t corner,
                          std::size_t other) {
  const bool in_front = s[other] > 0;
  return {corner_feature(corner), in_front ? &t[other] : &t[corner],
          in_front ? &t[corner] : &t[other]};
}

/// The interval in which a triangle cuts the line of both planes.
struct Interval {
  IntervalEnd to_front,
      to_back;  ///< where the outline comes to the front, and where it goes behind
  OpenFeature within = OpenFeature::face;  ///< the feature between them
};

/// Precondition: the corners are not all on the plane, nor all on one open side of it.
Interval interval_of(const TriangleCorners& t, const PlaneSides& s) {
  Interval interval;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, previous = (i + 2) % 3;
    if (s[i] * s[next] < 0) {
      const IntervalEnd end = {edge_feature(i), s[i] > 0 ? &t[i] : &t[next],
                               s[i] > 0 ? &t[next] : &t[i]};
      (s[i] < 0 ? interval.to_front : interval.to_back) = end;
    } else if (s[i] == 0 && s[next] != 0 && s[previous] != 0) {
      const IntervalEnd end = end_in_corner(t, s, i, next);
      if (s[previous] < 0 || s[next] > 0) interval.to_front = end;
      if (s[previous] > 0 || s[next] < 0) interval.to_back = end;
    } else if (s[i] == 0 && s[next] == 0) {
      const IntervalEnd first = end_in_corner(t, s, i, previous);
      const IntervalEnd second = end_in_corner(t, s, next, previous);
      interval = s[previous] > 0 ? Interval{second, first, edge_feature(i)}
                                 : Interval{first, second, edge_feature(i)};
    }
  }
  return interval;
}

/// 1 if `b` comes after `a` along the line, -1 before, 0 at the same point.
int order(const IntervalEnd& a, const IntervalEnd& b) {
  return orient3d(*a.front, *a.back, *b.front, *b.back);
}

CrossingEnd both(const IntervalEnd& a, const IntervalEnd& b) { return {a.feature, b.feature}; }

Crossing point(const CrossingEnd& end) { return {CrossingKind::point, {end, end}}; }

/// Precondition: both intervals exist.
Crossing cross_intervals(const Interval& a, const Interval& b) {
  const IntervalEnd &begin_a = a.to_front, &end_a = a.to_back;
  const IntervalEnd &begin_b = b.to_back, &end_b = b.to_front;
  const int b_after_a = order(end_a, begin_b), b_before_a = order(begin_a, end_b);
  if (b_after_a > 0 || b_before_a < 0) return {};
  if (b_after_a == 0) return point(both(end_a, begin_b));
  if (b_before_a == 0) return point(both(begin_a, end_b));
  const int begins = order(begin_a, begin_b), ends = order(end_a, end_b);
  Crossing crossing = {CrossingKind::segment, {}};
  crossing.ends[0] = {begins > 0 ? a.within : begin_a.feature,
                      begins < 0 ? b.within : begin_b.feature};
  crossing.ends[1] = {ends < 0 ? a.within : end_a.feature, ends > 0 ? b.within : end_b.feature};
  const bool a_is_point = begin_a.feature == end_a.feature;
  const bool b_is_point = begin_b.feature == end_b.feature;
  if (a_is_point || b_is_point) crossing = point(crossing.ends[0]);
  return crossing;
}

bool is_corner(OpenFeature f) { return f <= OpenFeature::corner2; }
bool is_edge(OpenFeature f) { return f >= OpenFeature::edge0 && f <= OpenFeature::edge2; }

struct Edge {
  Vec3 from, to;
};

/// Puts the end with the lesser coordinates first, so that both triangles with the edge agree.
Edge edge_of(const TriangleCorners& t, OpenFeature edge) {
  const std::size_t i = static_cast<std::size_t>(edge) - 3;
  const Vec3 &p = t[i], &q = t[(i + 1) % 3];
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z) ? Edge{p, q} : Edge{q, p};
}

double max_abs(const TriangleCorners& t) {
  return std::max({max_abs(Vec3d(t[0])), max_abs(Vec3d(t[1])), max_abs(Vec3d(t[2]))});
}

/// The point of an edge where a linear function with these values at its ends is zero.
Vec3 divided(const Edge& edge, double at_from, double at_to) {
  const double share = std::clamp(at_from / (at_from - at_to), 0.0, 1.0);
  return to_float(Vec3d(edge.from) + share * (Vec3d(edge.to) - Vec3d(edge.from)));
}

/// The point where an edge passes through the face of a triangle. The determinants of its ends are
/// those of `OrientedPlane::side`, with known errors. If the errors would move the point too far,
/// computes the determinants exactly.
Vec3 edge_through_face(const Edge& edge, const TriangleCorners& face) {
  const Vec3d origin(face[0]), u = Vec3d(face[1]) - origin, v = Vec3d(face[2]) - origin;
  const Vec3d normal = cross(u, v), from = Vec3d(edge.from) - origin, to = Vec3d(edge.to) - origin;
  const double at_from = dot(from, normal), at_to = dot(to, normal);
  const double length = max_abs(to - from);
  const double error = 2 * OrientedPlane::kRelativeError * max_abs(u) * max_abs(v) *
                       std::max(max_abs(from), max_abs(to));
  const double extent =
      std::max({max_abs(face), max_abs(Vec3d(edge.from)), max_abs(Vec3d(edge.to))});
  if (error * length < 0x1p-26 * extent * std::abs(at_from - at_to))
    return divided(edge, at_from, at_to);
  const Vec3d a(face[0]), b(face[1]), c(face[2]);
  return divided(edge, exact_orientation(a, b, c, Vec3d(edge.from)),
                 exact_orientation(a, b, c, Vec3d(edge.to)));
}

/// det(q - p, r - p) of two of the coordinates, rounded once.
double exact_turn(const Vec2d& p, const Vec2d& q, const Vec2d& r) {
  ExactSum<6> sum;  // products of floats are exact
  for (const double term : {q.x * r.y, -r.x * q.y, r.x * p.y, -p.x * r.y, p.x * q.y, -q.x * p.y})
    sum.add(term);
  return sum.rounded();
}

/// The crossing of two coplanar edges, projected along an axis that preserves the crossing.
Vec3 edge_through_edge(const Edge& a, const Edge& b) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2d p = without(b.from, axis), q = without(b.to, axis);
    const double at_from = exact_turn(p, q, without(a.from, axis));
    const double at_to = exact_turn(p, q, without(a.to, axis));
    if (at_from != at_to) return divided(a, at_from, at_to);
  }
  PELT_ASSERT(false);  // parallel edges do not cross
  return a.from;
}

}  // namespace

Crossing cross_triangles(const TriangleCorners& a, const TriangleCorners& b) {
  if (!triangles_intersect(a, b)) return {};
  const PlaneSides sides_a = sides_of(a, b), sides_b = sides_of(b, a);
  const bool a_on_plane = all_on_plane(sides_a), b_on_plane = all_on_plane(sides_b);
  if (a_on_plane && b_on_plane)
    return {has_collapsed(a) || has_collapsed(b) ? CrossingKind::collapsed : CrossingKind::coplanar,
            {}};
  // A collapsed triangle has no plane; all corners count as on it.
  if (a_on_plane || b_on_plane) return {CrossingKind::collapsed, {}};
  return cross_intervals(interval_of(a, sides_a), interval_of(b, sides_b));
}

Vec3 crossing_position(const CrossingEnd& end, const TriangleCorners& a, const TriangleCorners& b) {
  if (is_corner(end.a)) return a[static_cast<std::size_t>(end.a)];
  if (is_corner(end.b)) return b[static_cast<std::size_t>(end.b)];
  if (is_edge(end.a) && is_edge(end.b))
    return edge_through_edge(edge_of(a, end.a), edge_of(b, end.b));
  return is_edge(end.a) ? edge_through_face(edge_of(a, end.a), b)
                        : edge_through_face(edge_of(b, end.b), a);
}

}  // namespace pelt::detail
