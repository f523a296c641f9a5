#pragma once

/// The fifteen determinants of four corners of two moving triangles, with corners of both, as
/// cubics on a piece of the step: computed in double, with bounds of their errors.
///
/// Rounding, as in `moving_triage.cpp`, with u = 2^-53 instead of e: the error of a coefficient of
/// one of the ten determinants is below 127 u V, because the vectors are also interpolated to the
/// ends of the piece. The fifteen are sums of these:
///
///   sum of                              V      value      error of a coefficient
///   height: two determinants            A A D  < 13 V     2 * 127 + 13 = 267
///   edges[0] or [2]: three              A B D  < 19 V     3 * 127 + 32 = 413
///   edges[1]: a rise and two of these   A B D  < 49 V     267 + 2 * 413 + 80 = 1173
///
/// All other values are means of coefficients, and have the bounds of these. A piece is halved at
/// most 12 times. A half's coefficients are means of neighbours, taken three times, and each mean
/// rounds once: 36 relative errors. A value at one time is a sum of four products, of a
/// coefficient, three numbers with up to three relative errors each (`SignAtFloat`), and 3: at
/// most 15 relative errors. Heights therefore have errors below 267 + 51 * 13 = 930, edges below
/// 1173 + 51 * 49 = 3672, in units of u V. The bounds are 1024 and 4096.
///
/// Nothing underflows or overflows: differences of floats are multiples of 2^-149 below 2^62.

#include "base/double4.hpp"
#include "base/vec3.hpp"
#include "motion/moving_determinants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {
namespace moving {

inline constexpr int kMostHalvings = 12;

using Vectors = PairVectors<Vec3d>;

// Numbers of the determinants: the height of corner j of b over a's plane, the height of corner i
// of a over b's plane, orient3d of edge i of a and edge j of b.

inline constexpr unsigned kDeterminants = 15;

constexpr unsigned over_a(unsigned j) { return j; }
constexpr unsigned over_b(unsigned i) { return 3 + i; }
constexpr unsigned edges(unsigned i, unsigned j) { return 6 + 3 * i + j; }

/// A number for each determinant, and one 0.
using Fifteen = Double16;

/// The bounds in the head of this file.
inline Fifteen error_bounds(const Vectors& from, const Vectors& to) {
  const auto largest = [](const Vec3d& p, const Vec3d& q) {
    return std::max(
        {std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  };
  const double a = std::max(largest(from.u, to.u), largest(from.v, to.v));
  const double b = std::max(largest(from.r, to.r), largest(from.s, to.s));
  const double d = std::max(std::max(a, b), largest(from.w, to.w)) * 0x1p-53;
  const double h = 1024 * a * a * d, k = 1024 * b * b * d, e = 4096 * a * b * d;
  return Fifteen({h, h, h, k, k, k, e, e, e, e, e, e, e, e, e, 0});
}

/// Coefficients in the basis of Bernstein: the first ones of all determinants, the second ones, ...
using Cubics = std::array<Fifteen, 4>;

inline Fifteen fifteen(const PairOrientations<double>& of) {
  const auto &a = of.over_a, &b = of.over_b, &e = of.edges[0], &f = of.edges[1], &g = of.edges[2];
  return Fifteen({a[0], a[1], a[2], b[0], b[1], b[2], e[0], e[1], e[2], f[0], f[1], f[2], g[0],
                  g[1], g[2], 0});
}

inline Cubics fifteen_cubics(const Vectors& from, const Vectors& to) {
  TenDeterminants<BernsteinCubic<double>> d;
  compute_determinants(from, to, 1.0 / 3, d);
  Cubics cubics;
  for (std::size_t k = 0; k < 4; ++k)
    cubics[k] =
        fifteen(PairOrientations<double>({d.uvw[k], d.uvr[k], d.uvs[k], d.rsw[k], d.rsu[k],
                                          d.rsv[k], d.uwr[k], d.uws[k], d.vwr[k], d.vws[k]}));
  return cubics;
}

/// Values of the cubics, each at its own part of the piece, from 0 to 1.
inline Fifteen values_at(const Fifteen& part, const Cubics& c) {
  const Fifteen rest = Fifteen(1.0) - part;
  return rest * rest * (rest * c[0] + 3 * part * c[1]) +
         part * part * (3 * rest * c[2] + part * c[3]);
}

/// A part of the step.
struct Piece {
  double start = 0, end = 1;
  int depth = 0;
  Cubics cubics;
};

/// Makes `first` the first half of the piece, and `second` the second half.
inline void halve(Piece& first, Piece& second) {
  second.end = first.end;
  second.start = first.end = (first.start + first.end) / 2;
  second.depth = ++first.depth;
  const auto& [c0, c1, c2, c3] = first.cubics;
  const Fifteen c01 = 0.5 * (c0 + c1), c12 = 0.5 * (c1 + c2), c23 = 0.5 * (c2 + c3);
  const Fifteen c012 = 0.5 * (c01 + c12), c123 = 0.5 * (c12 + c23), middle = 0.5 * (c012 + c123);
  second.cubics = {middle, c123, c23, c3};
  first.cubics = {c0, c01, c012, middle};
}

/// The signs of the determinants that are certain, one bit for each determinant.
struct Signs {
  unsigned positive, negative;

  Signs(unsigned p, unsigned n) : positive(p), negative(n) {}
  Signs(const Fifteen& values, const Fifteen& errors)
      : positive(less(errors, values)), negative(less(values, -errors)) {}

  Signs operator-() const { return {negative, positive}; }
  friend Signs operator&(const Signs& s, const Signs& t) {
    return {s.positive & t.positive, s.negative & t.negative};
  }
};

/// The determinants of which both signs are certain and equal.
inline unsigned equal(const Signs& s, const Signs& t) {
  return (s.positive & t.positive) | (s.negative & t.negative);
}

// For each of the fifteen determinants, whether its features, a corner and a face or two edges,
// intersect at a time at which it is zero: by the signs of others at that time.
//
// Corner j of b and the face of a. Edge j of b, and the edge before it, are on lines that meet a's
// plane in this corner. If a line passes two edges of a on different sides, it does not meet a. If
// it passes all three on one side, it pierces a inside, and there is no other point of a's plane
// on it: the corner.
//
// Edges i of a and j of b. If both ends of one are on one side of the other triangle's plane, the
// edges are disjoint. Otherwise, if the ends of both are on different sides, each edge has exactly
// one point in the other triangle's plane, between its ends. The lines of the edges are in one
// plane and not parallel, so they meet, and they can only do so in both of these points.

/// The features of a determinant.
struct FeaturePair {
  enum class Kind : std::uint8_t { face_and_corner, corner_and_face, edges } kind;
  std::uint8_t i = 0, j = 0;  ///< the corner or edge of a and that of b; 0 for a face

  explicit FeaturePair(unsigned determinant) : kind(Kind::edges) {
    if (determinant < over_b(0)) {
      kind = Kind::face_and_corner, j = small(determinant - over_a(0));
    } else if (determinant < edges(0, 0)) {
      kind = Kind::corner_and_face, i = small(determinant - over_b(0));
    } else {
      const unsigned pair = determinant - edges(0, 0);
      i = small(pair / 3), j = small(pair % 3);
    }
  }

 private:
  static std::uint8_t small(unsigned number) { return static_cast<std::uint8_t>(number); }
};

// Three bits: of corners or edges. Nine bits: of pairs of edges, bit 3 i + j for i of a and j of b.

inline Signs three(const Signs& signs, unsigned first) {
  return {signs.positive >> first & 7, signs.negative >> first & 7};
}

/// The bits of the next corners or edges.
constexpr unsigned next(unsigned three) { return three >> 1 | (three & 1) << 2; }
inline Signs next(const Signs& three) { return {next(three.positive), next(three.negative)}; }

/// The corners at which edges begin or end: those of the same numbers, and the next ones.
constexpr unsigned ends_of(unsigned edges_of_one) {
  return edges_of_one | next(next(edges_of_one));
}

/// The first bit of each row, an edge of a.
constexpr unsigned first_of_rows(unsigned nine) {
  return (nine & 1) | (nine >> 2 & 2) | (nine >> 4 & 4);
}

/// All pairs with some edges of a, or of b.
constexpr unsigned rows(unsigned of_a) {
  return 7 * ((of_a & 1) | (of_a & 2) << 2 | (of_a & 4) << 4);
}
constexpr unsigned columns(unsigned of_b) { return 0b001001001 * of_b; }

/// Lines of edges of one triangle, as seen from the edges of the other one.
struct Lines {
  unsigned between;   ///< those that pass two edges on different sides
  unsigned piercing;  ///< those that pass three edges on one side

  static Lines of_a(const Signs& nine) {
    const auto any = [](unsigned n) { return first_of_rows(n | n >> 1 | n >> 2); };
    const auto all = [](unsigned n) { return first_of_rows(n & n >> 1 & n >> 2); };
    return {any(nine.positive) & any(nine.negative), all(nine.positive) | all(nine.negative)};
  }

  static Lines of_b(const Signs& nine) {
    const auto any = [](unsigned n) { return (n | n >> 3 | n >> 6) & 7; };
    const auto all = [](unsigned n) { return n & n >> 3 & n >> 6 & 7; };
    return {any(nine.positive) & any(nine.negative), all(nine.positive) | all(nine.negative)};
  }
};

/// The determinants whose features certainly are disjoint, or certainly intersect, when the
/// determinant is zero. The signs are those at this time.
struct Meetings {
  unsigned never, always;

  explicit Meetings(const Signs& signs) {
    const Signs heights_a = three(signs, over_b(0)), heights_b = three(signs, over_a(0));
    const Signs nine = {signs.positive >> edges(0, 0), signs.negative >> edges(0, 0)};
    const Lines of_a = Lines::of_a(nine), of_b = Lines::of_b(nine);
    never =
        join(ends_of(of_b.between), ends_of(of_a.between),
             rows(equal(heights_a, next(heights_a))) | columns(equal(heights_b, next(heights_b))));
    always = join(
        ends_of(of_b.piercing), ends_of(of_a.piercing),
        rows(equal(heights_a, -next(heights_a))) & columns(equal(heights_b, -next(heights_b))));
  }

 private:
  static unsigned join(unsigned corners_of_b, unsigned corners_of_a, unsigned pairs_of_edges) {
    return corners_of_b << over_a(0) | corners_of_a << over_b(0) | pairs_of_edges << edges(0, 0);
  }
};

}  // namespace moving
}  // namespace pelt::detail
