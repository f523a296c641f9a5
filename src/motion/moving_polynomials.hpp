#pragma once

/// Moving triangles, and the polynomials whose signs decide whether they intersect.

#include "exact/critical_time.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>
#include <bitset>
#include <cstddef>

namespace pelt::detail {

/// A triangle whose corners move in straight lines at constant speed, from time 0 to time 1.
struct MovingTriangle {
  TriangleCorners from, to;
};

/// A coordinate that moves from `from` to `to`, in a unit that all coordinates on this axis share.
struct MovingCoordinate {
  BigInteger<kCoordinateBits> from, to;
};

/// The corners of two triangles, first those of a, then those of b: x, y and z for each.
using MovingPoints = std::array<std::array<MovingCoordinate, 3>, 6>;

/// Precondition: all coordinates are finite and below 2^61.
MovingPoints moving_points(const MovingTriangle& a, const MovingTriangle& b);

/// Returns det(p_j - p_i, p_k - p_i, p_l - p_i) for the corners i, j, k and l, as a function of
/// time.
Cubic orient3d_polynomial(const MovingPoints& points, const std::array<std::size_t, 4>& corners);

/// The polynomials in time whose signs decide whether two moving triangles intersect. For corners
/// i, j, k and l of six:
///
///   number   count   degree   value
///   0..14    15      3        det(p_j - p_i, p_k - p_i, p_l - p_i), i < j < k < l
///   15..74   60      2        the determinant of p_j - p_i and p_k - p_i seen along an axis, i < j
///   < k 75..119  45      1        the coordinate of p_j less that of p_i, i < j
///
/// Coefficients are integers. With coordinates of at most b bits, a difference of coordinates moves
/// from u to u + d with |u| < 2^(b + 1) and |d| < 2^(b + 2). A product of three of them has
/// coefficients of at most 2^(3b + 3), 3 * 2^(3b + 4), 3 * 2^(3b + 5) and 2^(3b + 6), and a
/// determinant is a sum of six: less than 2^(3b + 10) = 2^kCoefficientBits.
///
/// About 50 KB; a polynomial is computed when it is first needed.
class MovingPolynomials {
 public:
  static constexpr std::size_t kOrient3d = 15, kOrient2d = 60, kCompare = 45;
  static constexpr std::size_t kCount = kOrient3d + kOrient2d + kCompare;

  explicit MovingPolynomials(const MovingPoints& points);

  const Cubic& operator[](std::size_t number);

  /// A polynomial up to its sign. `number` is kCount for the zero polynomial.
  struct Signed {
    std::size_t number = kCount;
    int sign = 0;
  };

  /// Polynomials of any corners, also of equal ones: the determinants of `predicates.hpp`, and the
  /// coordinate of j less that of i.
  static Signed orient3d(std::array<std::size_t, 4> corners);
  static Signed orient2d(std::size_t axis, std::array<std::size_t, 3> corners);
  static Signed compare(std::size_t axis, std::size_t i, std::size_t j);

 private:
  const MovingPoints& points_;
  std::array<Cubic, kCount> polynomials_;
  std::bitset<kCount> is_computed_;
};

}  // namespace pelt::detail
