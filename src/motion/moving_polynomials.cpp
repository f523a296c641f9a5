#include "motion/moving_polynomials.hpp"

#include "exact/scaled_float.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace pelt::detail {
namespace {

/// Sets of corners, as masks of six bits, in ascending order among those of their size.
struct CornerSets {
  std::array<std::uint8_t, 64> rank{};
  std::array<std::array<std::uint8_t, 20>, 7> masks{};

  constexpr CornerSets() {
    std::array<std::uint8_t, 7> count{};
    for (unsigned mask = 0; mask < 64; ++mask) {
      const auto size = static_cast<std::size_t>(std::popcount(mask));
      rank[mask] = count[size];
      masks[size][count[size]++] = static_cast<std::uint8_t>(mask);
    }
  }
};

constexpr CornerSets kCornerSets;

template <std::size_t kSize>
std::array<std::size_t, kSize> corners_of(std::size_t rank) {
  std::array<std::size_t, kSize> corners{};
  unsigned mask = kCornerSets.masks[kSize][rank];
  for (std::size_t& corner : corners) {
    corner = static_cast<std::size_t>(std::countr_zero(mask));
    mask &= mask - 1;
  }
  return corners;
}

/// The rank of a set of corners, and the sign of the permutation that sorts them: 0 if two are
/// equal.
template <std::size_t kSize>
MovingPolynomials::Signed sorted(const std::array<std::size_t, kSize>& corners) {
  unsigned mask = 0;
  int sign = 1;
  for (std::size_t i = 0; i < kSize; ++i) {
    if (mask >> corners[i] & 1) return {};
    if (std::popcount(mask >> corners[i]) % 2 != 0) sign = -sign;
    mask |= 1u << corners[i];
  }
  return {kCornerSets.rank[mask], sign};
}

/// start + slope t.
struct Linear {
  BigInteger<kCoordinateBits + 2> start, slope;
};

Linear difference(const MovingPoints& points, std::size_t axis, std::size_t i, std::size_t j) {
  const MovingCoordinate &p = points[i][axis], &q = points[j][axis];
  Linear result;
  result.start = decltype(result.start)(q.from);
  result.start -= decltype(result.start)(p.from);
  result.slope = decltype(result.slope)(q.to);
  result.slope -= decltype(result.slope)(p.to);
  result.slope -= result.start;
  return result;
}

void add_product(Coefficient& sum, const auto& a, const auto& b) {
  Coefficient product;
  product.assign_product(a, b);
  sum += product;
}

void subtract_product(Coefficient& sum, const auto& a, const auto& b) {
  Coefficient product;
  product.assign_product(a, b);
  sum -= product;
}

/// a d - b c
Cubic minor(const Linear& a, const Linear& b, const Linear& c, const Linear& d) {
  Cubic result;
  auto& r = result.coefficients;
  add_product(r[0], a.start, d.start);
  subtract_product(r[0], b.start, c.start);
  add_product(r[1], a.start, d.slope);
  add_product(r[1], a.slope, d.start);
  subtract_product(r[1], b.start, c.slope);
  subtract_product(r[1], b.slope, c.start);
  add_product(r[2], a.slope, d.slope);
  subtract_product(r[2], b.slope, c.slope);
  return result;
}

Cubic orient2d_of(const MovingPoints& points, std::size_t axis,
                  const std::array<std::size_t, 3>& corners) {
  const auto& [i, j, k] = corners;
  const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
  return minor(difference(points, next, i, j), difference(points, next, i, k),
               difference(points, last, i, j), difference(points, last, i, k));
}

Cubic difference_of(const MovingPoints& points, std::size_t axis,
                    const std::array<std::size_t, 2>& corners) {
  const Linear d = difference(points, axis, corners[0], corners[1]);
  Cubic result;
  result.coefficients[0] = Coefficient(d.start);
  result.coefficients[1] = Coefficient(d.slope);
  return result;
}

float coordinate(const Vec3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

void set_axis(MovingPoints& points, std::size_t axis, const MovingTriangle& a,
              const MovingTriangle& b) {
  std::array<std::array<float, 2>, 6> values{};
  int unit = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const MovingTriangle& triangle = i < 3 ? a : b;
    values[i] = {coordinate(triangle.from[i % 3], axis), coordinate(triangle.to[i % 3], axis)};
    for (const float value : values[i])
      if (value != 0) unit = std::min(unit, OddTimesPower(value).exponent);
  }
  for (std::size_t i = 0; i < 6; ++i)
    points[i][axis] = {scaled<kCoordinateBits>(values[i][0], unit),
                       scaled<kCoordinateBits>(values[i][1], unit)};
}

}  // namespace

MovingPoints moving_points(const MovingTriangle& a, const MovingTriangle& b) {
  MovingPoints points;
  for (std::size_t axis = 0; axis < 3; ++axis) set_axis(points, axis, a, b);
  return points;
}

Cubic orient3d_polynomial(const MovingPoints& points, const std::array<std::size_t, 4>& corners) {
  const auto& [i, j, k, l] = corners;
  Cubic result;
  auto& r = result.coefficients;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
    const Cubic area = minor(difference(points, next, i, j), difference(points, next, i, k),
                             difference(points, last, i, j), difference(points, last, i, k));
    const Linear height = difference(points, axis, i, l);
    for (std::size_t power = 0; power < 3; ++power) {
      add_product(r[power], area.coefficients[power], height.start);
      add_product(r[power + 1], area.coefficients[power], height.slope);
    }
  }
  return result;
}

MovingPolynomials::MovingPolynomials(const MovingPoints& points) : points_(points) {}

const Cubic& MovingPolynomials::operator[](std::size_t number) {
  PELT_ASSERT(number < kCount);
  Cubic& polynomial = polynomials_[number];
  if (is_computed_[number]) return polynomial;
  is_computed_[number] = true;
  if (number < kOrient3d) return polynomial = orient3d_polynomial(points_, corners_of<4>(number));
  number -= kOrient3d;
  if (number < kOrient2d)
    return polynomial = orient2d_of(points_, number / 20, corners_of<3>(number % 20));
  number -= kOrient2d;
  return polynomial = difference_of(points_, number / 15, corners_of<2>(number % 15));
}

MovingPolynomials::Signed MovingPolynomials::orient3d(std::array<std::size_t, 4> corners) {
  return sorted(corners);
}

MovingPolynomials::Signed MovingPolynomials::orient2d(std::size_t axis,
                                                      std::array<std::size_t, 3> corners) {
  Signed result = sorted(corners);
  if (result.sign != 0) result.number += kOrient3d + 20 * axis;
  return result;
}

MovingPolynomials::Signed MovingPolynomials::compare(std::size_t axis, std::size_t i,
                                                     std::size_t j) {
  Signed result = sorted(std::array{i, j});
  if (result.sign != 0) result.number += kOrient3d + kOrient2d + 15 * axis;
  return result;
}

}  // namespace pelt::detail
