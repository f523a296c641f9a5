#pragma once

/// The distance of a triangle and a segment by linear algebra over the rationals, an approach
/// independent of the library's.

#include <pelt/math.hpp>

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::test {

using RationalPoint = std::array<mpq_class, 3>;

inline RationalPoint to_rational(const Vec3& v) {
  return {mpq_class(static_cast<double>(v.x)), mpq_class(static_cast<double>(v.y)),
          mpq_class(static_cast<double>(v.z))};
}

inline RationalPoint difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Solves a linear system given by its rows, each followed by its right-hand side; nullopt if it is
/// singular.
inline std::optional<std::vector<mpq_class>> solve(std::vector<std::vector<mpq_class>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && rows[pivot][column] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == column || rows[i][column] == 0) continue;
      const mpq_class factor = rows[i][column] / rows[column][column];
      for (std::size_t j = column; j <= n; ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  std::vector<mpq_class> solution;
  for (std::size_t i = 0; i < n; ++i) solution.push_back(rows[i][n] / rows[i][i]);
  return solution;
}

/// The squared distance of the planes, lines or points through two sets of points, if exactly one
/// pair of points is closest and this pair is inside both hulls.
inline std::optional<mpq_class> squared_distance_inside(const std::vector<RationalPoint>& p,
                                                        const std::vector<RationalPoint>& q) {
  std::vector<RationalPoint> directions;
  for (std::size_t i = 1; i < p.size(); ++i) directions.push_back(difference(p[i], p[0]));
  for (std::size_t i = 1; i < q.size(); ++i) directions.push_back(difference(q[0], q[i]));
  RationalPoint between = difference(p[0], q[0]);
  std::vector<std::vector<mpq_class>> rows(directions.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const RationalPoint& d : directions) rows[i].push_back(dot(directions[i], d));
    rows[i].push_back(-dot(directions[i], between));
  }
  const auto places = solve(rows);
  if (!places) return std::nullopt;
  mpq_class first_p = 1, first_q = 1;
  for (std::size_t i = 0; i < places->size(); ++i) {
    if ((*places)[i] < 0) return std::nullopt;
    (i + 1 < p.size() ? first_p : first_q) -= (*places)[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
      between[axis] += (*places)[i] * directions[i][axis];
  }
  if (first_p < 0 || first_q < 0) return std::nullopt;
  return dot(between, between);
}

inline std::vector<RationalPoint> subset_of(const std::vector<RationalPoint>& points,
                                            unsigned subset) {
  std::vector<RationalPoint> members;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (subset >> i & 1) members.push_back(points[i]);
  return members;
}

/// The squared distance of two hulls. Some subsets of both have a unique closest pair inside their
/// hulls.
inline mpq_class squared_distance(const std::vector<RationalPoint>& p,
                                  const std::vector<RationalPoint>& q) {
  std::optional<mpq_class> least;
  for (unsigned of_p = 1; of_p < 1u << p.size(); ++of_p)
    for (unsigned of_q = 1; of_q < 1u << q.size(); ++of_q) {
      const auto found = squared_distance_inside(subset_of(p, of_p), subset_of(q, of_q));
      if (found && (!least || *found < *least)) least = found;
    }
  return *least;
}

}  // namespace pelt::test
