#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace pelt::test {

template <typename Integer>
using IntegerPoint = std::array<Integer, 3>;

template <typename Integer>
using IntegerTriangle = std::array<IntegerPoint<Integer>, 3>;

/// Decides whether the hulls of two triples of points intersect, by a method independent of the
/// triangle pair test: linear algebra over the integers instead of orientations.
///
/// The hulls intersect if and only if some sum c_i p_i = 0 with sum c_i = 0, not all zero, has c_i
/// >= 0 on one triple and c_i <= 0 on the other. Then there is one of minimal support, at most five
/// points, which is the only dependency of its points up to a factor. It therefore suffices to test
/// the subsets of at most five points that have exactly one dependency.
template <typename Integer>
class HullsMeet {
 public:
  HullsMeet(const IntegerTriangle<Integer>& a, const IntegerTriangle<Integer>& b)
      : points_{&a[0], &a[1], &a[2], &b[0], &b[1], &b[2]} {}

  /// Whether the hulls of the points in `subset` intersect. Bit i is set for point i.
  bool operator()(unsigned subset = 0b111111) {
    return subset == 0b111111 ? any_smaller_subset(subset) : proves(subset);
  }

 private:
  struct Members {
    explicit Members(unsigned subset) {
      for (unsigned i = 0; i < 6; ++i) {
        if (subset >> i & 1) index[count++] = i;
      }
    }
    std::array<unsigned, 6> index{};
    std::size_t count = 0;
  };

  /// The number of independent dependencies of a subset, and the coefficients if there is only one.
  struct Dependencies {
    std::size_t count = 0;
    std::array<Integer, 5> coefficients;
  };

  bool any_smaller_subset(unsigned subset) {
    for (unsigned i = 0; i < 6; ++i) {
      if ((subset >> i & 1) && proves(subset & ~(1u << i))) return true;
    }
    return false;
  }

  /// Whether `subset` or a part of it has a dependency that proves a common point.
  bool proves(unsigned subset) {
    const std::uint64_t bit = std::uint64_t{1} << subset;
    if (visited_ & bit) return false;
    visited_ |= bit;
    const Members members(subset);
    if (members.count < 2) return false;
    const Dependencies found = dependencies(members);
    if (found.count == 0) return false;
    if (found.count > 1) return any_smaller_subset(subset);
    return has_opposite_signs(members, found.coefficients);
  }

  static bool has_opposite_signs(const Members& members, const std::array<Integer, 5>& c) {
    bool forward = true, backward = true;
    for (std::size_t i = 0; i < members.count; ++i) {
      const bool of_a = members.index[i] < 3;
      if (c[i] > 0) (of_a ? backward : forward) = false;
      if (c[i] < 0) (of_a ? forward : backward) = false;
    }
    return forward || backward;
  }

  /// Fraction-free elimination (Bareiss 1968) of the differences to the first member.
  Dependencies dependencies(const Members& members) const {
    const std::size_t columns = members.count - 1;
    std::array<std::array<Integer, 4>, 3> m;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t j = 0; j < columns; ++j) {
        m[axis][j] = (*points_[members.index[j + 1]])[axis] - (*points_[members.index[0]])[axis];
      }
    }
    std::array<std::size_t, 3> pivot_column{};
    std::size_t rank = 0, free_column = 0;
    Integer pivot = 1;
    for (std::size_t column = 0; column < columns; ++column) {
      if (rank == 3 || !bring_pivot(m, rank, column)) {
        free_column = column;
        continue;
      }
      eliminate(m, rank, column, columns, pivot);
      pivot = m[rank][column];
      pivot_column[rank++] = column;
    }
    Dependencies result;
    result.count = columns - rank;
    if (result.count != 1) return result;
    auto& c = result.coefficients;
    c[free_column + 1] = -pivot;
    for (std::size_t i = 0; i < rank; ++i) c[pivot_column[i] + 1] = m[i][free_column];
    c[0] = 0;
    for (std::size_t j = 1; j <= columns; ++j) c[0] -= c[j];
    return result;
  }

  template <typename Matrix>
  static bool bring_pivot(Matrix& m, std::size_t row, std::size_t column) {
    for (std::size_t i = row; i < 3; ++i) {
      if (m[i][column] == 0) continue;
      if (i != row) std::swap(m[i], m[row]);
      return true;
    }
    return false;
  }

  template <typename Matrix>
  static void eliminate(Matrix& m, std::size_t row, std::size_t column, std::size_t columns,
                        const Integer& divisor) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == row) continue;
      for (std::size_t j = 0; j < columns; ++j) {
        if (j == column) continue;
        const Integer minor = m[i][j] * m[row][column] - m[i][column] * m[row][j];
        m[i][j] = minor / divisor;
      }
      m[i][column] = 0;
    }
  }

  std::array<const IntegerPoint<Integer>*, 6> points_;
  std::uint64_t visited_ = 0;
};

/// Whether the boxes of the triples are disjoint: then the hulls are, too.
template <typename Number>
bool have_disjoint_boxes(const IntegerTriangle<Number>& a, const IntegerTriangle<Number>& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto range = [axis](const IntegerTriangle<Number>& t) {
      return std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    };
    if (range(a).second < range(b).first || range(b).second < range(a).first) return true;
  }
  return false;
}

template <typename Integer>
bool hulls_meet(const IntegerTriangle<Integer>& a, const IntegerTriangle<Integer>& b) {
  return HullsMeet<Integer>(a, b)();
}

}  // namespace pelt::test
