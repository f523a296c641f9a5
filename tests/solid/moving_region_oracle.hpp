#pragma once

/// When a moving triangle first touches a region, by methods that share nothing with the library:
/// numbers of GMP, and all roots of all polynomials instead of the next ones.

#include "motion/moving_oracle.hpp"
#include "solid/region_triangle.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pelt::test {

inline IntegerPolynomial operator+(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  return p - (IntegerPolynomial{} - q);
}

using PolynomialVector = std::array<IntegerPolynomial, 3>;

inline PolynomialVector difference(const PolynomialVector& p, const PolynomialVector& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline IntegerPolynomial dot(const PolynomialVector& p, const PolynomialVector& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline PolynomialVector cross(const PolynomialVector& p, const PolynomialVector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Values as integers in the unit 2^-300, which divides all products of two floats.
inline mpz_class in_small_unit(float value) {
  const mpq_class scaled = mpq_class(double{value}) * mpq_class(mpz_class(1) << 300);
  return scaled.get_num();
}

inline IntegerPolynomial linear(const mpz_class& from, const mpz_class& to) {
  IntegerPolynomial p = {from, to - from};
  trim(p);
  return p;
}

/// The earliest of the roots at which something holds.
class FirstRoot {
 public:
  template <typename Holds>
  void search(const IntegerPolynomial& p, const Holds& holds) {
    std::vector<OracleTime> times;
    OracleRoots::append(p, times);
    for (OracleTime& time : times) {
      if (first_ && time.compare(*first_) >= 0) continue;
      if (holds(time)) first_ = time;
    }
  }

  std::optional<detail::FirstTouch> touch() {
    if (!first_) return std::nullopt;
    return detail::FirstTouch{first_->rounded_down(), false};
  }

 private:
  std::optional<OracleTime> first_;
};

/// A point of the triangle with the weights w is in all faces if w . s <= 0 for each face, where s
/// are the distances of the corners outside of the face. The weights are not negative: w . -e <= 0
/// for each unit vector e. If there are such weights, they are also found where two of these
/// inequalities are equations. Which of these weights satisfy all the others changes only at roots
/// of determinants of three rows, and of sums of 2 x 2 determinants.
class FacesOracle {
 public:
  FacesOracle(const detail::MovingTriangle& triangle, std::span<const detail::Face> faces) {
    for (const detail::Face& face : faces) {
      PolynomialVector row;
      for (std::size_t k = 0; k < 3; ++k)
        row[k] = linear(side(face, triangle.from[k]), side(face, triangle.to[k]));
      rows_.push_back(row);
    }
    rows_.push_back({IntegerPolynomial{-1}, {}, {}});
    rows_.push_back({IntegerPolynomial{}, {-1}, {}});
    rows_.push_back({IntegerPolynomial{}, {}, {-1}});
  }

  std::optional<detail::FirstTouch> first_touch() {
    OracleTime start({}, 0, 0, true);
    if (touches(start)) return detail::FirstTouch{0, true};
    FirstRoot first;
    const auto holds = [this](OracleTime& time) { return touches(time); };
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t j = i + 1; j < rows_.size(); ++j) {
        const PolynomialVector weights = cross(rows_[i], rows_[j]);
        first.search(weights[0] + weights[1] + weights[2], holds);
        for (std::size_t k = j + 1; k < rows_.size(); ++k)
          first.search(dot(weights, rows_[k]), holds);
      }
    return first.touch();
  }

 private:
  static mpz_class side(const detail::Face& face, const Vec3& p) {
    const auto term = [](float n, float a, float o) {
      return mpz_class(in_small_unit(n) * (in_small_unit(a) - in_small_unit(o)));
    };
    return term(face.normal.x, p.x, face.origin.x) + term(face.normal.y, p.y, face.origin.y) +
           term(face.normal.z, p.z, face.origin.z) - (in_small_unit(face.offset) << 300);
  }

  bool touches(OracleTime& time) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t j = i + 1; j < rows_.size(); ++j)
        if (are_weights(time, cross(rows_[i], rows_[j]))) return true;
    return false;
  }

  bool are_weights(OracleTime& time, const PolynomialVector& weights) const {
    const int sum = time.sign_of(weights[0] + weights[1] + weights[2]);
    if (sum == 0) return false;
    for (const PolynomialVector& row : rows_)
      if (time.sign_of(dot(weights, row)) * sum > 0) return false;
    return true;
  }

  std::vector<PolynomialVector> rows_;
};

/// The squared distance of two hulls, each of one to three points, is attained at points with
/// positive weights of some of the points, which minimise the squared distance of the planes, lines
/// or points through them. These weights are a quotient of determinants, by Cramer's rule for the
/// normal equations. Whether they are positive, and the distance is at most the radius, changes
/// only at roots of the numerators and denominators.
class CapsuleOracle {
 public:
  CapsuleOracle(const detail::MovingTriangle& triangle, const Capsule& capsule) {
    const auto point = [](const Vec3& from, const Vec3& to) {
      return PolynomialVector{linear(in_small_unit(from.x), in_small_unit(to.x)),
                              linear(in_small_unit(from.y), in_small_unit(to.y)),
                              linear(in_small_unit(from.z), in_small_unit(to.z))};
    };
    for (std::size_t k = 0; k < 3; ++k) points_.push_back(point(triangle.from[k], triangle.to[k]));
    points_.push_back(point(capsule.a, capsule.a));
    points_.push_back(point(capsule.b, capsule.b));
    const mpz_class radius = in_small_unit(capsule.radius);
    squared_radius_ = {radius * radius};
    trim(squared_radius_);
    for (unsigned of_triangle = 1; of_triangle < 8; ++of_triangle)
      for (unsigned of_segment = 8; of_segment < 32; of_segment += 8) add(of_triangle | of_segment);
  }

  std::optional<detail::FirstTouch> first_touch() {
    OracleTime start({}, 0, 0, true);
    if (touches(start)) return detail::FirstTouch{0, true};
    FirstRoot first;
    const auto holds = [this](OracleTime& time) { return touches(time); };
    for (const Pair& pair : pairs_) {
      first.search(pair.determinant, holds);
      first.search(pair.beyond, holds);
      for (const IntegerPolynomial& weight : pair.weights) first.search(weight, holds);
    }
    return first.touch();
  }

 private:
  /// Points of both hulls. If the determinant is not zero, one pair of points of their planes,
  /// lines or points is closest. Its weights are the numerators divided by the determinant.
  struct Pair {
    IntegerPolynomial determinant;
    std::vector<IntegerPolynomial> weights;
    IntegerPolynomial beyond;  ///< (squared distance - squared radius) times squared determinant
  };

  static IntegerPolynomial determinant(const std::vector<std::vector<IntegerPolynomial>>& m) {
    if (m.empty()) return {1};
    IntegerPolynomial sum;
    for (std::size_t column = 0; column < m.size(); ++column) {
      std::vector<std::vector<IntegerPolynomial>> rest;
      for (std::size_t i = 1; i < m.size(); ++i) {
        rest.push_back(m[i]);
        rest.back().erase(rest.back().begin() + static_cast<std::ptrdiff_t>(column));
      }
      const IntegerPolynomial term = m[0][column] * determinant(rest);
      sum = column % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
  }

  void add(unsigned members) {
    std::vector<std::size_t> hulls[2];
    for (std::size_t i = 0; i < 5; ++i)
      if (members >> i & 1) hulls[i / 3].push_back(i);
    std::vector<PolynomialVector> directions;
    for (int side = 0; side < 2; ++side)
      for (std::size_t i = 1; i < hulls[side].size(); ++i) {
        const PolynomialVector &p = points_[hulls[side][i]], &q = points_[hulls[side][0]];
        directions.push_back(side == 0 ? difference(p, q) : difference(q, p));
      }
    const PolynomialVector base = difference(points_[hulls[0][0]], points_[hulls[1][0]]);

    // Normal equations of |base + sum x_i direction_i|^2.
    const std::size_t n = directions.size();
    std::vector<std::vector<IntegerPolynomial>> matrix(n, std::vector<IntegerPolynomial>(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) matrix[i][k] = dot(directions[i], directions[k]);
    Pair pair{determinant(matrix), {}, {}};
    std::vector<IntegerPolynomial> x;
    PolynomialVector between = {base[0] * pair.determinant, base[1] * pair.determinant,
                                base[2] * pair.determinant};
    for (std::size_t column = 0; column < n; ++column) {
      auto replaced = matrix;
      for (std::size_t i = 0; i < n; ++i)
        replaced[i][column] = IntegerPolynomial{} - dot(directions[i], base);
      x.push_back(determinant(replaced));
      for (std::size_t axis = 0; axis < 3; ++axis)
        between[axis] = between[axis] + x.back() * directions[column][axis];
    }
    std::size_t next = 0;
    for (const auto& hull : hulls) {
      IntegerPolynomial first = pair.determinant;
      for (std::size_t i = 1; i < hull.size(); ++i) {
        first = first - x[next];
        pair.weights.push_back(x[next++]);
      }
      pair.weights.push_back(first);
    }
    pair.beyond = dot(between, between) - squared_radius_ * pair.determinant * pair.determinant;
    pairs_.push_back(pair);
  }

  static bool is_near(OracleTime& time, const Pair& pair) {
    const int determinant = time.sign_of(pair.determinant);
    if (determinant == 0) return false;
    for (const IntegerPolynomial& weight : pair.weights)
      if (time.sign_of(weight) * determinant < 0) return false;
    return time.sign_of(pair.beyond) <= 0;
  }

  bool touches(OracleTime& time) const {
    for (const Pair& pair : pairs_)
      if (is_near(time, pair)) return true;
    return false;
  }

  std::vector<PolynomialVector> points_;
  IntegerPolynomial squared_radius_;
  std::vector<Pair> pairs_;
};

}  // namespace pelt::test
