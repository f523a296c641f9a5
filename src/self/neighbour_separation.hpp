#pragma once

/// Certifies that two triangles of a moving surface that share corners never intersect, apart from
/// these. A template over numbers and points: eight pairs in float, or one pair in double.
///
/// One shared corner v. Let a1 and a2 be the corners of one triangle that are not shared, b1 and b2
/// those of the other, all seen from v. Each triangle is in the cone of its two corners, and the
/// triangles only meet in v if a plane through v separates the cones, in one of these ways:
///   The plane of one triangle, with both corners of the other strictly on one side.
///   The plane through v, ai and bj, with the other a and the other b strictly on different sides.
/// Each cone then meets the plane in one edge only. The edges do not overlap, because ai is not in
/// the plane of b1 and b2. With Hj = [a1 a2 bj] and Gi = [b1 b2 ai], a2 is on the side -Hj of the
/// plane of a1 and bj, a1 on the side Hj of that of a2 and bj, b2 on the side Gi of that of ai and
/// b1, and b1 on the side -Gi of that of ai and b2.
///   A plane through v and a spoke, along a direction n, with the other corner of the spoke's
/// triangle strictly on one side and both corners of the other triangle strictly on the other.
/// These sides are the signs of n . (x cross y), for the spoke x. Flat surfaces need this.
///
/// Two shared corners, u and u + e. Let p and q be the corners that are not shared, seen from u.
/// The triangles only meet in the edge e if [e p q] is not zero, or if a plane through e, along a
/// direction n, has p and q strictly on different sides: n . (e cross p) and n . (e cross q) have
/// different signs.
///
/// These values are cubics or quadratics in time, and have a certain sign at all times if all
/// coefficients in the basis of Bernstein have. The direction n is constant; any one is valid.
///
/// Rounding. Let e = 2^-24 for floats. Determinants: as the coefficients of the ten in
/// `moving_triage.cpp`, below 73 e V, where V bounds the products of three components. Products
/// with n: six products of two rounded differences and a component of n, each with at most 8
/// relative errors (2 components, product, difference, sum of two cross products, product with n,
/// two sums): below 49 e V. In double, with u = 2^-53, the vectors are also interpolated to the
/// ends of a part of the step, which adds two relative errors to each of two or three components:
/// below 110 u V and 73 u V. The bounds are 128 and 64 in float, 256 and 128 in double.
///   Underflow in float: a product of two components has an error of at most 2^-150, which is
/// multiplied by a third one, below 2^62, or by n; twelve of these are below 2^-80, and below
/// 2^-140 |n|. Overflow makes the bounds infinite or NaN before the values: they are computed from
/// 128 V.

#include "motion/moving_determinants.hpp"

#include <cstddef>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A vector at the start and at the end.
template <typename Point>
struct MovingVector {
  Point from, to;
};

/// Two triangles that share one corner: their other corners, seen from it.
template <typename Point>
struct CornerNeighbours {
  MovingVector<Point> a[2], b[2];
};

/// Two triangles that share two corners: the shared edge, and the other corners, seen from its
/// start.
template <typename Point>
struct EdgeNeighbours {
  MovingVector<Point> edge, p, q;
};

/// Where a value is certainly positive, and where negative, at all times.
template <typename Mask>
struct SignsForever {
  Mask positive, negative;
};

/// `Kit` has the types Number, Point and Mask, and: the numbers `half()`, `third()`,
/// `determinant_units()`, `projection_units()`, `tiny()`; `largest(p)`, the largest absolute
/// component; `max(x, y)`.
template <typename Kit>
class NeighbourSeparation {
  using Number = typename Kit::Number;
  using Point = typename Kit::Point;
  using Mask = typename Kit::Mask;
  using Vector = MovingVector<Point>;
  using Signs = SignsForever<Mask>;
  using Cross = MovingCross<Point, Number>;

 public:
  /// Where the triangles certainly only meet in the shared corner.
  static Mask are_apart(const CornerNeighbours<Point>& pair) {
    const auto& [a, b] = pair;
    const Number size_a = Kit::max(size(a[0]), size(a[1]));
    const Number size_b = Kit::max(size(b[0]), size(b[1]));
    const Cross cross_a = cross_of(a[0], a[1]), cross_b = cross_of(b[0], b[1]);
    const Number bound_h = determinant_bound(size_a * size_a, size_b);
    const Number bound_g = determinant_bound(size_b * size_b, size_a);
    const Signs h[2] = {determinant(cross_a, b[0], bound_h), determinant(cross_a, b[1], bound_h)};
    const Signs g[2] = {determinant(cross_b, a[0], bound_g), determinant(cross_b, a[1], bound_g)};
    return equal(h[0], h[1]) | equal(g[0], g[1]) | equal(h[0], g[0]) | opposite(h[1], g[0]) |
           opposite(h[0], g[1]) | equal(h[1], g[1]) |
           are_apart_in_projection(pair, cross_a, cross_b, size_a, size_b);
  }

  /// Where the triangles certainly only meet in the shared edge.
  static Mask are_apart(const EdgeNeighbours<Point>& pair) {
    const auto& [edge, p, q] = pair;
    const Number size_e = size(edge), size_p = size(p), size_q = size(q);
    const Cross cross_p = cross_of(edge, p), cross_q = cross_of(edge, q);
    const Signs fold = determinant(cross_p, q, determinant_bound(size_e * size_p, size_q));
    const Point n = cross_p.twice_middle() - cross_q.twice_middle();
    const Number size_n = Kit::largest(n);
    const Signs side_p = along(n, cross_p, projection_bound(size_n, size_e * size_p));
    const Signs side_q = along(n, cross_q, projection_bound(size_n, size_e * size_q));
    return fold.positive | fold.negative | opposite(side_p, side_q);
  }

 private:
  static Number size(const Vector& v) { return Kit::max(Kit::largest(v.from), Kit::largest(v.to)); }

  static Cross cross_of(const Vector& x, const Vector& y) {
    return Cross(x.from, x.to, y.from, y.to);
  }

  static Number determinant_bound(const Number& two, const Number& one) {
    return two * one * Number(128) * Kit::determinant_units() + Kit::tiny();
  }
  static Number projection_bound(const Number& n, const Number& two) {
    return two * n * Number(128) * Kit::projection_units() + (n + Number(1)) * Kit::tiny();
  }

  static Signs determinant(const Cross& of, const Vector& with, const Number& bound) {
    BernsteinCubic<Number> c;
    of.times(with.from, with.to, Kit::third(), c);
    const Number least = Kit::min(Kit::min(c[0], c[1]), Kit::min(c[2], c[3]));
    const Number most = Kit::max(Kit::max(c[0], c[1]), Kit::max(c[2], c[3]));
    return {bound < least, most < Number(0) - bound};
  }

  static Signs along(const Point& n, const Cross& of, const Number& bound) {
    Number q[3];
    of.along(n, Kit::half(), q);
    const Number least = Kit::min(Kit::min(q[0], q[1]), q[2]);
    const Number most = Kit::max(Kit::max(q[0], q[1]), q[2]);
    return {bound < least, most < Number(0) - bound};
  }

  static Mask equal(const Signs& s, const Signs& t) {
    return (s.positive & t.positive) | (s.negative & t.negative);
  }
  static Mask opposite(const Signs& s, const Signs& t) {
    return (s.positive & t.negative) | (s.negative & t.positive);
  }

  static Mask are_apart_in_projection(const CornerNeighbours<Point>& pair, const Cross& cross_a,
                                      const Cross& cross_b, const Number& size_a,
                                      const Number& size_b) {
    const Point n = cross_a.twice_middle() + cross_b.twice_middle();
    const Number size_n = Kit::largest(n);
    const Signs turn_a = along(n, cross_a, projection_bound(size_n, size_a * size_a));
    const Signs turn_b = along(n, cross_b, projection_bound(size_n, size_b * size_b));
    const Number bound = projection_bound(size_n, size_a * size_b);
    const auto turn = [&](int i, int k) { return along(n, cross_of(pair.a[i], pair.b[k]), bound); };
    const Signs from_a0[2] = {turn(0, 0), turn(0, 1)}, from_a1[2] = {turn(1, 0), turn(1, 1)};
    const Mask by_a0 = opposite(turn_a, from_a0[0]) & opposite(turn_a, from_a0[1]);
    const Mask by_a1 = equal(turn_a, from_a1[0]) & equal(turn_a, from_a1[1]);
    const Mask by_b0 = equal(turn_b, from_a0[0]) & equal(turn_b, from_a1[0]);
    const Mask by_b1 = opposite(turn_b, from_a0[1]) & opposite(turn_b, from_a1[1]);
    return by_a0 | by_a1 | by_b0 | by_b1;
  }
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
