#pragma once

/// The intersection of two convex hulls by linear algebra over the rationals. Shares no code with
/// the library.

#include "rational_distance.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::test {

using RationalPoints = std::vector<RationalPoint>;

/// Eliminates the unknowns of three equations, each followed by its right-hand side. Returns
/// nullopt if there is no solution or more than one.
inline std::optional<std::vector<mpq_class>> only_solution(
    std::array<std::vector<mpq_class>, 3> rows, std::size_t unknowns) {
  if (unknowns > 3) return std::nullopt;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t pivot = column;
    while (pivot < 3 && rows[pivot][column] == 0) ++pivot;
    if (pivot == 3) return std::nullopt;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == column || rows[i][column] == 0) continue;
      const mpq_class factor = rows[i][column] / rows[column][column];
      for (std::size_t j = column; j <= unknowns; ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  for (std::size_t i = unknowns; i < 3; ++i)
    if (rows[i][unknowns] != 0) return std::nullopt;
  std::vector<mpq_class> solution;
  for (std::size_t i = 0; i < unknowns; ++i) solution.push_back(rows[i][unknowns] / rows[i][i]);
  return solution;
}

/// The only common point of the planes, lines or points through two sets of points, if it exists
/// and is in both hulls.
inline std::optional<RationalPoint> only_common_point(const RationalPoints& p,
                                                      const RationalPoints& q) {
  const std::size_t of_p = p.size() - 1, of_q = q.size() - 1;
  std::array<std::vector<mpq_class>, 3> rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 1; i <= of_p; ++i) rows[axis].push_back(p[i][axis] - p[0][axis]);
    for (std::size_t i = 1; i <= of_q; ++i) rows[axis].push_back(q[0][axis] - q[i][axis]);
    rows[axis].push_back(q[0][axis] - p[0][axis]);
  }
  const auto places = only_solution(std::move(rows), of_p + of_q);
  if (!places) return std::nullopt;
  mpq_class first_p = 1, first_q = 1;
  RationalPoint point = p[0];
  for (std::size_t i = 0; i < places->size(); ++i) {
    const mpq_class& place = (*places)[i];
    if (place < 0) return std::nullopt;
    (i < of_p ? first_p : first_q) -= place;
    if (i >= of_p) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[axis] += place * (p[i + 1][axis] - p[0][axis]);
  }
  if (first_p < 0 || first_q < 0) return std::nullopt;
  return point;
}

inline bool have_disjoint_boxes(const RationalPoints& p, const RationalPoints& q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto is_less = [axis](const RationalPoint& x, const RationalPoint& y) {
      return x[axis] < y[axis];
    };
    const auto [low_p, high_p] = std::minmax_element(p.begin(), p.end(), is_less);
    const auto [low_q, high_q] = std::minmax_element(q.begin(), q.end(), is_less);
    if (is_less(*high_p, *low_q) || is_less(*high_q, *low_p)) return true;
  }
  return false;
}

/// Whether one of the points holds whose hull is the intersection of the hulls of `p` and `q`.
///
/// The pairs of coefficients that represent a common point as a mean of `p` and as a mean of `q`
/// form a polytope. Each extreme point of the intersection is the image of an extreme point of this
/// polytope, whose positive coefficients are the only solution for their points.
template <typename Holds>
bool any_common_point(const RationalPoints& p, const RationalPoints& q, const Holds& holds) {
  if (have_disjoint_boxes(p, q)) return false;
  for (unsigned of_p = 1; of_p < 1u << p.size(); ++of_p)
    for (unsigned of_q = 1; of_q < 1u << q.size(); ++of_q)
      if (const auto point = only_common_point(subset_of(p, of_p), subset_of(q, of_q)))
        if (holds(*point)) return true;
  return false;
}

inline bool hulls_intersect(const RationalPoints& p, const RationalPoints& q) {
  return any_common_point(p, q, [](const RationalPoint&) { return true; });
}

}  // namespace pelt::test
