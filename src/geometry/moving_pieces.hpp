#pragma once

/// The signs that decide whether two moving triangles intersect on a piece of the step, computed in
/// double.
///
/// Rounding, as in `moving_triage.cpp`, with u = 2^-53 instead of e: the error of a coefficient is
/// below 127 u V. To bisect, coefficients are replaced by means of neighbours, three times; a mean
/// rounds once, below 6.1 u V. At depth 12, the error is below (127 + 12 * 18.4) u V < 348 u V. In
/// units of u V, sums have errors below
///
///   height, two determinants                   2 * 348 + 13 = 709                      bound 1024
///   rise, two determinants                     709
///   edges[0] or [2], three determinants        3 * 348 + 32 = 1076
///   edges[1]: a rise and two of these          709 + 2 * 1076 + 80 = 2941              bound 3072
///   separator: edges and two rises             2941 + 2 * 709 + 135 = 4494             bound 5120
///
/// Nothing underflows or overflows: differences of floats are multiples of 2^-149 below 2^62.

#include "base/vec3.hpp"
#include "geometry/moving_determinants.hpp"
#include "geometry/moving_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {
namespace moving {

inline constexpr int kMostBisections = 12;

using Vectors = PairVectors<Vec3d>;
using Bernstein = BernsteinCubic<double>;
using Cubics = TenDeterminants<Bernstein>;
using Orientations = PairOrientations<double>;

inline double largest(const Vec3d& p) {
  return std::max(std::max(std::abs(p.x), std::abs(p.y)), std::abs(p.z));
}

inline double largest(const Vec3d& p, const Vec3d& q) { return std::max(largest(p), largest(q)); }

/// 1 or -1 if the sign of a value with an error up to `error` is certain; otherwise 0.
inline int sign_of(double value, double error) {
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// The bounds in the head of this file.
struct Errors {
  double over_a, over_b, edges, separators;

  Errors(const Vectors& from, const Vectors& to) {
    const double a = std::max(largest(from.u, to.u), largest(from.v, to.v));
    const double b = std::max(largest(from.r, to.r), largest(from.s, to.s));
    const double d = std::max(std::max(a, b), largest(from.w, to.w)) * 0x1p-53;
    over_a = 1024 * a * a * d;
    over_b = 1024 * b * b * d;
    edges = 3072 * a * b * d;
    separators = 5120 * a * b * d;
  }
};

inline TenDeterminants<double> coefficients(const Cubics& d, std::size_t k) {
  return {d.uvw[k], d.uvr[k], d.uvs[k], d.rsw[k], d.rsu[k],
          d.rsv[k], d.uwr[k], d.uws[k], d.vwr[k], d.vws[k]};
}

/// A part of the step.
struct Piece {
  double start = 0, end = 1;
  int depth = 0;
  Cubics cubics;
};

/// Replaces the coefficients by those for the first half, and sets those for the second one.
inline void halve(Bernstein& first, Bernstein& second) {
  const double c01 = (first[0] + first[1]) * 0.5, c12 = (first[1] + first[2]) * 0.5;
  const double c23 = (first[2] + first[3]) * 0.5;
  const double c012 = (c01 + c12) * 0.5, c123 = (c12 + c23) * 0.5;
  const double middle = (c012 + c123) * 0.5;
  second[0] = middle, second[1] = c123, second[2] = c23, second[3] = first[3];
  first[1] = c01, first[2] = c012, first[3] = middle;
}

/// Makes `first` the first half of the piece, and `second` the second half.
inline void halve(Piece& first, Piece& second) {
  second.end = first.end;
  second.start = first.end = (first.start + first.end) / 2;
  second.depth = ++first.depth;
  Cubics &p = first.cubics, &q = second.cubics;
  halve(p.uvw, q.uvw), halve(p.uvr, q.uvr), halve(p.uvs, q.uvs);
  halve(p.rsw, q.rsw), halve(p.rsu, q.rsu), halve(p.rsv, q.rsv);
  halve(p.uwr, q.uwr), halve(p.uws, q.uws), halve(p.vwr, q.vwr), halve(p.vws, q.vws);
}

using Heights = double[3];

inline bool all_beyond(const Heights& heights, int sign, double error) {
  return sign_of(heights[0], error) == sign && sign_of(heights[1], error) == sign &&
         sign_of(heights[2], error) == sign;
}

/// An edge from a corner on the side `sign` to a corner on the other side; 3 if there is none.
inline std::size_t edge_from(const Heights& heights, int sign, double error) {
  for (std::size_t i = 0; i < 3; ++i)
    if (sign_of(heights[i], error) == sign && sign_of(heights[(i + 1) % 3], error) == -sign)
      return i;
  return 3;
}

inline bool all_known(const Heights& heights, double error) {
  return std::all_of(heights, heights + 3, [&](double h) { return sign_of(h, error) != 0; });
}

/// Whether the triangles intersect at one time, as in `triage`.
inline CertainAnswer intersect_at(const Orientations& at, const Errors& errors) {
  for (const int sign : {1, -1})
    if (all_beyond(at.over_a, sign, errors.over_a) || all_beyond(at.over_b, sign, errors.over_b))
      return CertainAnswer::no;
  if (!all_known(at.over_a, errors.over_a) || !all_known(at.over_b, errors.over_b))
    return CertainAnswer::unknown;
  const auto order = [&](int sign) {
    const std::size_t of_a = edge_from(at.over_b, sign, errors.over_b);
    return sign_of(at.edges[of_a][edge_from(at.over_a, sign, errors.over_a)], errors.edges);
  };
  const int down = order(1), up = order(-1);
  if (down < 0 && up > 0) return CertainAnswer::yes;
  if (down > 0 || up < 0) return CertainAnswer::no;
  return CertainAnswer::unknown;
}

/// The four values of everything that has a sign, on one piece.
class PieceSigns {
 public:
  PieceSigns(const Piece& piece, const Errors& errors)
      : errors_(errors),
        at_{Orientations(coefficients(piece.cubics, 0)),
            Orientations(coefficients(piece.cubics, 1)),
            Orientations(coefficients(piece.cubics, 2)),
            Orientations(coefficients(piece.cubics, 3))} {}

  CertainAnswer at_start() const { return intersect_at(at_[0], errors_); }
  CertainAnswer at_end() const { return intersect_at(at_[3], errors_); }

  bool are_separated() const {
    for (const int sign : {1, -1})
      if (always([&](const Orientations& at) {
            return all_beyond(at.over_a, sign, errors_.over_a);
          }) ||
          always(
              [&](const Orientations& at) { return all_beyond(at.over_b, sign, errors_.over_b); }))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (edges_separate(i, j)) return true;
    return false;
  }

  /// The determinants that may be zero on the piece: which of fifteen, of which kind.
  struct Zero {
    std::size_t count = 0;
    bool is_once = false;  ///< there is one, and it has exactly one root
    int sign_at_start = 0;
    enum class Kind : std::uint8_t { over_a, over_b, edges } kind = Kind::edges;
    std::size_t i = 0, j = 0;  ///< the corner, or the edges

    double of(const Orientations& values) const {
      if (kind == Kind::over_a) return values.over_a[i];
      if (kind == Kind::over_b) return values.over_b[i];
      return values.edges[i][j];
    }

    double error(const Errors& errors) const {
      if (kind == Kind::over_a) return errors.over_a;
      return kind == Kind::over_b ? errors.over_b : errors.edges;
    }
  };

  Zero zero() const {
    Zero result;
    for (std::size_t i = 0; i < 3; ++i) {
      add(result, Zero::Kind::over_a, i, 0);
      add(result, Zero::Kind::over_b, i, 0);
      for (std::size_t j = 0; j < 3; ++j) add(result, Zero::Kind::edges, i, j);
    }
    return result;
  }

 private:
  template <typename Condition>
  bool always(const Condition& condition) const {
    return condition(at_[0]) && condition(at_[3]) && condition(at_[1]) && condition(at_[2]);
  }

  bool edges_separate(std::size_t i, std::size_t j) const {
    return always([&](const Orientations& at) {
             return at.edges[i][j] - std::max(at.rise_a[i], 0.0) - std::max(at.rise_b[j], 0.0) >
                    errors_.separators;
           }) ||
           always([&](const Orientations& at) {
             return at.edges[i][j] - std::min(at.rise_a[i], 0.0) - std::min(at.rise_b[j], 0.0) <
                    -errors_.separators;
           });
  }

  int sign(std::size_t k, Zero::Kind kind, std::size_t i, std::size_t j) const {
    if (kind == Zero::Kind::over_a) return sign_of(at_[k].over_a[i], errors_.over_a);
    if (kind == Zero::Kind::over_b) return sign_of(at_[k].over_b[i], errors_.over_b);
    return sign_of(at_[k].edges[i][j], errors_.edges);
  }

  /// Counts a determinant whose sign is not certainly constant. With different signs at the ends,
  /// it has exactly one sign change in its coefficients, and one root, if one of the others has
  /// certainly the sign of the end beside it.
  void add(Zero& zeros, Zero::Kind kind, std::size_t i, std::size_t j) const {
    const int s0 = sign(0, kind, i, j), s1 = sign(1, kind, i, j);
    const int s2 = sign(2, kind, i, j), s3 = sign(3, kind, i, j);
    if (s0 != 0 && s0 == s1 && s1 == s2 && s2 == s3) return;
    const bool is_once = s0 != 0 && s0 == -s3 && (s1 == s0 || s2 == s3);
    zeros = {zeros.count + 1, zeros.count == 0 && is_once, s0, kind, i, j};
  }

  const Errors& errors_;
  Orientations at_[4];
};

}  // namespace moving
}  // namespace pelt::detail
