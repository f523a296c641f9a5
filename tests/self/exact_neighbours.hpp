#pragma once

/// The table of neighbours.hpp in rational numbers, word by word, and the rule that it amounts
/// to for triangles that have not collapsed. Shares no code with the library.

#include "geometry/common_points.hpp"
#include "self/neighbours.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pelt::test {

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
