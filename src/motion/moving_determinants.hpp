#pragma once

/// Ten determinants of two moving triangles, as cubics in time.
///
/// A pair of triangles is given by five vectors: edges u = a1 - a0 and v = a2 - a0, r = b1 - b0 and
/// s = b2 - b0, and the offset w = b0 - a0. All signs of the exact test (triangle_pair.cpp) are
/// signs of sums of determinants of three of these:
///   corners of b over a's plane:  [u v w],  [u v w] + [u v r],  [u v w] + [u v s],
///   corners of a over b's plane:  -[r s w],  -[r s w] + [r s u],  -[r s w] + [r s v],
///   orient3d of edge 0 of a and edges 0, 1, 2 of b:  [u w r],  [u w s] - [u w r] + [r s u],
/// -[u w s]; of edge 2 of a: the negative, with v instead of u; and of edge 1 of a, because the
/// three edges of a sum to zero: the height of b's edge over a's plane minus these two. Only w
/// grows with the distance of the triangles, and no determinant contains it twice.
///
/// The vectors move linearly, from p0 to p1. In the basis of Bernstein, a cross product has the
/// coefficients q0 = a0 x b0, q1 = (a0 x b1 + a1 x b0) / 2, q2 = a1 x b1, and its product with a
/// vector l the coefficients q0 l0, (q0 l1 + 2 q1 l0) / 3, (2 q1 l1 + q2 l0) / 3, q2 l1.

#include <cstddef>

namespace pelt::detail {

template <typename Point>
struct PairVectors {
  Point u, v, r, s, w;

  PairVectors(const Point (&a)[3], const Point (&b)[3])
      : u(a[1] - a[0]), v(a[2] - a[0]), r(b[1] - b[0]), s(b[2] - b[0]), w(b[0] - a[0]) {}
};

/// The vectors at one time.
template <typename Point, typename Number>
Point between(const Number& time, const Point& from, const Point& to) {
  return (Number(1) - time) * from + time * to;
}

template <typename Point, typename Number>
PairVectors<Point> between(const Number& time, const PairVectors<Point>& from,
                           const PairVectors<Point>& to) {
  PairVectors<Point> result = from;
  result.u = between(time, from.u, to.u);
  result.v = between(time, from.v, to.v);
  result.r = between(time, from.r, to.r);
  result.s = between(time, from.s, to.s);
  result.w = between(time, from.w, to.w);
  return result;
}

/// Coefficients of a cubic in the basis of Bernstein on [0, 1].
template <typename Number>
using BernsteinCubic = Number[4];

/// The determinants [u v w], [u v r], ..., [v w s]: cubics, or values of these at one time.
template <typename Cubic>
struct TenDeterminants {
  Cubic uvw, uvr, uvs, rsw, rsu, rsv, uwr, uws, vwr, vws;
};

/// A product of two moving vectors.
template <typename Point, typename Number>
class MovingCross {
 public:
  MovingCross(const Point& a0, const Point& a1, const Point& b0, const Point& b1)
      : start_(cross(a0, b0)), twice_middle_(cross(a0, b1) + cross(a1, b0)), end_(cross(a1, b1)) {}

  /// The product with another moving vector.
  void times(const Point& l0, const Point& l1, const Number& a_third,
             BernsteinCubic<Number>& result) const {
    result[0] = dot(start_, l0);
    result[1] = (dot(start_, l1) + dot(twice_middle_, l0)) * a_third;
    result[2] = (dot(twice_middle_, l1) + dot(end_, l0)) * a_third;
    result[3] = dot(end_, l1);
  }

  /// The product with a constant vector: a quadratic, in the basis of Bernstein.
  void along(const Point& n, const Number& a_half, Number (&result)[3]) const {
    result[0] = dot(start_, n);
    result[1] = dot(twice_middle_, n) * a_half;
    result[2] = dot(end_, n);
  }

  const Point& twice_middle() const { return twice_middle_; }

 private:
  Point start_, twice_middle_, end_;
};

template <typename Point, typename Number>
void compute_determinants(const PairVectors<Point>& from, const PairVectors<Point>& to,
                          const Number& a_third, TenDeterminants<BernsteinCubic<Number>>& result) {
  using Cross = MovingCross<Point, Number>;
  const Cross uv(from.u, to.u, from.v, to.v), rs(from.r, to.r, from.s, to.s);
  const Cross uw(from.u, to.u, from.w, to.w), vw(from.v, to.v, from.w, to.w);
  uv.times(from.w, to.w, a_third, result.uvw);
  uv.times(from.r, to.r, a_third, result.uvr);
  uv.times(from.s, to.s, a_third, result.uvs);
  rs.times(from.w, to.w, a_third, result.rsw);
  rs.times(from.u, to.u, a_third, result.rsu);
  rs.times(from.v, to.v, a_third, result.rsv);
  uw.times(from.r, to.r, a_third, result.uwr);
  uw.times(from.s, to.s, a_third, result.uws);
  vw.times(from.r, to.r, a_third, result.vwr);
  vw.times(from.s, to.s, a_third, result.vws);
}

/// The values whose signs decide the triangle pair test: at one time, or one coefficient each.
template <typename Number>
struct PairOrientations {
  Number over_a[3], over_b[3];  ///< heights of b's corners over a's plane, of a's over b's
  Number rise_a[3], rise_b[3];  ///< along edges: of a over b's plane, of b over a's
  Number edges[3][3];           ///< orient3d of edge i of a and edge j of b

  explicit PairOrientations(const TenDeterminants<Number>& d)
      : over_a{d.uvw, d.uvw + d.uvr, d.uvw + d.uvs},
        over_b{Number(0) - d.rsw, d.rsu - d.rsw, d.rsv - d.rsw},
        rise_a{d.rsu, d.rsv - d.rsu, Number(0) - d.rsv},
        rise_b{d.uvr, d.uvs - d.uvr, Number(0) - d.uvs},
        edges{{d.uwr, d.uws - d.uwr + d.rsu, Number(0) - d.uws},
              {},
              {Number(0) - d.vwr, d.vwr - d.vws - d.rsv, d.vws}} {
    for (std::size_t j = 0; j < 3; ++j) edges[1][j] = rise_b[j] - edges[0][j] - edges[2][j];
  }
};

}  // namespace pelt::detail
