#pragma once

/// When two moving triangles first meet, by a method that shares nothing with the library: numbers
/// of GMP, roots isolated by Descartes' rule, signs at roots by refined intervals and greatest
/// common divisors, hulls by linear algebra, and instead of the library's polynomials of all six
/// corners those of the fifteen pairs of a corner and a face or of two edges. Of triangles that are
/// disjoint at first, such a pair meets first, and it can only meet when its four corners are
/// coplanar. If they always are, only when three of them are collinear, seen along an axis, or when
/// two of them have an equal coordinate.

#include "hulls_meet.hpp"
#include "motion/moving_pair.hpp"
#include "oracle_time.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::test {

/// The corners of two triangles, first those of a, then those of b. x, y and z of each, at both
/// ends, in a unit that all coordinates on this axis share.
using MovingCorners = std::array<std::array<std::array<mpz_class, 2>, 3>, 6>;

class MovingOracle {
 public:
  /// A triple of numbers of corners: equal ones, an edge as {i, k, k}, or a face.
  using Corners = std::array<std::size_t, 3>;

  explicit MovingOracle(const MovingCorners& corners) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& [from, to] = corners[i][axis];
        points_[i][axis] = {from, to - from};
        trim(points_[i][axis]);
      }
  }

  MovingOracle(const detail::MovingTriangle& a, const detail::MovingTriangle& b)
      : MovingOracle(moving_corners(a, b)) {}

  std::optional<detail::FirstMeeting> first_meeting() {
    if (const auto meeting = meeting_at_start({0, 1, 2}, {3, 4, 5})) return meeting;
    for (std::size_t i = 0; i < 3; ++i) {
      search({i, i, i}, {3, 4, 5});
      search({0, 1, 2}, {3 + i, 3 + i, 3 + i});
      for (std::size_t k = 0; k < 3; ++k) search(edge(i, 0), edge(k, 3));
    }
    auto meeting = first_found();
    if (meeting) find_features(*meeting);
    return meeting;
  }

  /// The same for a corner and a face or for two edges, without features.
  std::optional<detail::FirstMeeting> first_meeting_of(const Corners& a, const Corners& b) {
    if (const auto meeting = meeting_at_start(a, b)) return meeting;
    search(a, b);
    return first_found();
  }

 private:
  using Kind = FeatureKind;

  static MovingCorners moving_corners(const detail::MovingTriangle& a,
                                      const detail::MovingTriangle& b) {
    int unit = 0;
    for (const detail::MovingTriangle* t : {&a, &b})
      for (const auto* corners : {&t->from, &t->to})
        for (const Vec3& p : *corners)
          for (const float x : {p.x, p.y, p.z}) unit = std::max(unit, bits_below_one(x));
    MovingCorners result;
    for (std::size_t i = 0; i < 6; ++i) {
      const detail::MovingTriangle& triangle = i < 3 ? a : b;
      const Vec3 &from = triangle.from[i % 3], &to = triangle.to[i % 3];
      const auto integer = [unit](float x) { return mpz_class(std::ldexp(double{x}, unit)); };
      result[i] = {{{integer(from.x), integer(to.x)},
                    {integer(from.y), integer(to.y)},
                    {integer(from.z), integer(to.z)}}};
    }
    return result;
  }

  /// The least n for which x is a multiple of 2^-n.
  static int bits_below_one(float x) {
    int n = 0;
    while (std::ldexp(double{x}, n) != std::trunc(std::ldexp(double{x}, n))) ++n;
    return n;
  }

  std::optional<detail::FirstMeeting> meeting_at_start(const Corners& a, const Corners& b) const {
    OracleTime start({}, 0, 0, true);
    if (!hulls_meet_at(start, a, b)) return std::nullopt;
    detail::FirstMeeting meeting;
    meeting.at_start = true;
    return meeting;
  }

  std::optional<detail::FirstMeeting> first_found() {
    if (!first_) return std::nullopt;
    detail::FirstMeeting meeting;
    meeting.time = first_->rounded_down();
    return meeting;
  }

  static Corners edge(std::size_t i, std::size_t first) {
    return {first + i, first + (i + 1) % 3, first + (i + 1) % 3};
  }

  bool have_disjoint_boxes(OracleTime& time, const Corners& a, const Corners& b) const {
    const auto all_have_sign = [&](std::size_t axis, int sign) {
      for (const std::size_t i : a)
        for (const std::size_t k : b)
          if (time.sign_of(difference(axis, i, k)) != sign) return false;
      return true;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (all_have_sign(axis, 1) || all_have_sign(axis, -1)) return true;
    return false;
  }

  bool hulls_meet_at(OracleTime& time, const Corners& a, const Corners& b) const {
    if (time.is_dyadic())
      return hulls_meet<mpz_class>(
          a, b, [&](const IntegerPolynomial& coordinate) { return time.value_of(coordinate); });
    if (have_disjoint_boxes(time, a, b)) return false;
    return hulls_meet<NumberAt>(
        a, b, [&](const IntegerPolynomial& coordinate) { return NumberAt(coordinate, &time); });
  }

  template <typename Number, typename ValueOf>
  bool hulls_meet(const Corners& a, const Corners& b, const ValueOf& value_of) const {
    IntegerTriangle<Number> of_a, of_b;
    unsigned distinct = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        of_a[i][axis] = value_of(points_[a[i]][axis]);
        of_b[i][axis] = value_of(points_[b[i]][axis]);
      }
      if (i == 0 || a[i] != a[i - 1]) distinct |= 1u << i;
      if (i == 0 || b[i] != b[i - 1]) distinct |= 8u << i;
    }
    return HullsMeet<Number>(of_a, of_b)(distinct);
  }

  IntegerPolynomial difference(std::size_t axis, std::size_t i, std::size_t k) const {
    return points_[k][axis] - points_[i][axis];
  }

  IntegerPolynomial area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    return difference(u, i, j) * difference(v, i, k) - difference(v, i, j) * difference(u, i, k);
  }

  IntegerPolynomial volume(const std::array<std::size_t, 4>& p) const {
    IntegerPolynomial minus_sum;
    for (std::size_t axis = 0; axis < 3; ++axis)
      minus_sum = minus_sum - area(axis, p[0], p[1], p[2]) * difference(axis, p[0], p[3]);
    return minus_sum;
  }

  /// The times at which two features with four distinct corners may meet first.
  std::vector<OracleTime> times_of(const std::array<std::size_t, 4>& p) const {
    std::vector<OracleTime> times;
    const IntegerPolynomial coplanar = volume(p);
    OracleRoots::append(coplanar, times);
    if (!coplanar.empty()) return times;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) {
          OracleRoots::append(difference(axis, p[i], p[j]), times);
          for (std::size_t k = j + 1; k < 4; ++k)
            OracleRoots::append(area(axis, p[i], p[j], p[k]), times);
        }
    return times;
  }

  void search(const Corners& a, const Corners& b) {
    std::array<std::size_t, 4> distinct{};
    std::size_t count = 0;
    unsigned seen = 0;
    for (const Corners& corners : {a, b})
      for (const std::size_t corner : corners) {
        if ((seen >> corner & 1) == 0) distinct[count++] = corner;
        seen |= 1u << corner;
      }
    for (OracleTime& time : times_of(distinct)) {
      if (first_ && time.compare(*first_) >= 0) continue;
      if (hulls_meet_at(time, a, b)) first_ = time;
    }
  }

  void find_features(detail::FirstMeeting& meeting) {
    for (const auto& [kind_a, kind_b] :
         std::vector<std::pair<Kind, Kind>>{{Kind::corner, Kind::corner},
                                            {Kind::corner, Kind::edge},
                                            {Kind::edge, Kind::corner},
                                            {Kind::corner, Kind::face},
                                            {Kind::face, Kind::corner},
                                            {Kind::edge, Kind::edge}})
      for (std::uint8_t i = 0; i < (kind_a == Kind::face ? 1 : 3); ++i)
        for (std::uint8_t k = 0; k < (kind_b == Kind::face ? 1 : 3); ++k)
          if (hulls_meet_at(*first_, corners_of(kind_a, i, 0), corners_of(kind_b, k, 3))) {
            meeting.a = {kind_a, i};
            meeting.b = {kind_b, k};
            return;
          }
  }

  static Corners corners_of(Kind kind, std::size_t i, std::size_t first) {
    if (kind == Kind::corner) return {first + i, first + i, first + i};
    if (kind == Kind::edge) return edge(i, first);
    return {first, first + 1, first + 2};
  }

  std::array<std::array<IntegerPolynomial, 3>, 6> points_;
  std::optional<OracleTime> first_;
};

}  // namespace pelt::test
