#pragma once

/// The table of neighbours.hpp in rational numbers, word by word, and the rule that it amounts
/// to for triangles that have not collapsed. Shares no code with the library.

#include "geometry/rational_distance.hpp"
#include "self/neighbours.hpp"

#include <algorithm>
#include <cstdint>
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

class ExactNeighbours {
 public:
  ExactNeighbours(const detail::SurfaceTriangle& a, const detail::SurfaceTriangle& b) {
    const std::vector<Corner> of_a = distinct_corners(a), of_b = distinct_corners(b);
    all_a_ = points(of_a, {}, false), all_b_ = points(of_b, {}, false);
    shared_ = points(of_a, of_b, true);
    own_a_ = points(of_a, of_b, false), own_b_ = points(of_b, of_a, false);
  }

  /// Number of distinct corners that the triangles share.
  std::size_t shared_count() const { return shared_.size(); }

  bool has_collapsed() const { return has_collapsed(all_a_) || has_collapsed(all_b_); }

  /// Whether all corners are in one plane. Precondition: the triangles have not collapsed, and
  /// share two corners.
  bool is_flat() const {
    const RationalPoint normal =
        cross(difference(all_a_[1], all_a_[0]), difference(all_a_[2], all_a_[0]));
    return dot(normal, difference(own_b_[0], shared_[0])) == 0;
  }

  /// Whether two shared corners exist, and the other corners lie in one plane with them, strictly
  /// on the same side.
  bool is_folded_flat() const {
    if (shared_.size() != 2 || own_a_.size() != 1 || own_b_.size() != 1) return false;
    const RationalPoint edge = difference(shared_[1], shared_[0]);
    const RationalPoint to_a = cross(edge, difference(own_a_[0], shared_[0]));
    const RationalPoint to_b = cross(edge, difference(own_b_[0], shared_[0]));
    return cross(to_a, to_b) == RationalPoint{0, 0, 0} && dot(to_a, to_b) > 0;
  }

  bool intersect_by_table() const {
    if (shared_.empty()) return hulls_intersect(all_a_, all_b_);
    if (own_a_.empty() && own_b_.empty()) return true;
    return is_folded_flat() || (!own_a_.empty() && hulls_intersect(own_a_, all_b_)) ||
           (!own_b_.empty() && hulls_intersect(own_b_, all_a_));
  }

  /// Whether the triangles have a common point outside the hull of the shared corners, or share all
  /// corners. Precondition: the triangles have not collapsed.
  bool intersect_by_rule() const {
    if (shared_.size() == 3) return true;
    return any_common_point(all_a_, all_b_, [this](const RationalPoint& point) {
      return shared_.empty() || !hulls_intersect({point}, shared_);
    });
  }

 private:
  /// A corner with its surface vertex. Equal corners are shared.
  struct Corner {
    std::uint32_t vertex;
    RationalPoint point;

    bool operator==(const Corner& other) const {
      return vertex == other.vertex && point == other.point;
    }
  };

  static bool contains(const std::vector<Corner>& corners, const Corner& corner) {
    return std::find(corners.begin(), corners.end(), corner) != corners.end();
  }

  static std::vector<Corner> distinct_corners(const detail::SurfaceTriangle& t) {
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < 3; ++i)
      if (const Corner corner = {t.vertices[i], to_rational(t.corners[i])};
          !contains(corners, corner))
        corners.push_back(corner);
    return corners;
  }

  /// The points of the corners of `a` that `b` also has, or does not have.
  static RationalPoints points(const std::vector<Corner>& a, const std::vector<Corner>& b,
                               bool in_both) {
    RationalPoints chosen;
    for (const Corner& corner : a)
      if (contains(b, corner) == in_both) chosen.push_back(corner.point);
    return chosen;
  }

  static RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static bool has_collapsed(const RationalPoints& t) {
    return t.size() < 3 ||
           cross(difference(t[1], t[0]), difference(t[2], t[0])) == RationalPoint{0, 0, 0};
  }

  RationalPoints all_a_, all_b_, shared_, own_a_, own_b_;
};

}  // namespace pelt::test
