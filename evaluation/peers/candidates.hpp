#pragma once

/// Pelt's narrow phase, for libraries that expose their candidates.

#include "geometry/triangle_pair.hpp"

#include <pelt/collide.hpp>

#include <span>
#include <vector>

namespace pelt::peers {

/// A body at its last update.
struct PosedBody {
  PosedBody(std::span<const Triangle> its_triangles, std::span<const Vec3> rest)
      : triangles(its_triangles), rest_positions(rest.begin(), rest.end()) {}
  PosedBody(const PosedBody&) = delete;
  PosedBody& operator=(const PosedBody&) = delete;

  detail::TriangleCorners corners(std::uint32_t triangle) const {
    const Triangle& v = triangles[triangle];
    return {positions[v[0]], positions[v[1]], positions[v[2]]};
  }

  std::span<const Triangle> triangles;
  std::vector<Vec3> rest_positions;  ///< until the first update
  std::span<const Vec3> positions = rest_positions;
};

/// Tests the candidates of one query and appends the pairs that intersect, up to a limit.
class Candidates {
 public:
  Candidates(const PosedBody& a, const PosedBody& b, std::vector<Contact>& contacts,
             std::uint32_t max_contacts)
      : a_(a), b_(b), contacts_(contacts), wanted_(max_contacts) {
    work_.cut_short = wanted_ == 0;
  }

  /// False once the limit is reached; other candidates are ignored.
  bool wants_more() const { return wanted_ > 0; }

  void add(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    if (!wants_more()) return;
    ++work_.triangle_pairs;
    if (detail::triangles_intersect(a_.corners(triangle_a), b_.corners(triangle_b)))
      append(triangle_a, triangle_b);
  }

  const QueryStats& work() const { return work_; }

 private:
  void append(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    contacts_.push_back({triangle_a, triangle_b});
    work_.cut_short = --wanted_ == 0;
  }

  const PosedBody &a_, &b_;
  std::vector<Contact>& contacts_;
  std::uint32_t wanted_;
  QueryStats work_;
};

}  // namespace pelt::peers
