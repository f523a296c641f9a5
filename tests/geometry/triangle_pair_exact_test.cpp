/// The triangle pair test against exact integers, millions of pairs.
#include "geometry/triangle_pair.hpp"

#include "exact/finite_floats.hpp"
#include "exact/predicates.hpp"
#include "motion/hulls_meet.hpp"
#include "triangle_cases.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

namespace pelt::test {
namespace {

using detail::TriangleCorners;
using detail::triangles_intersect;

__extension__ using Int128 = __int128;

/// Cases that a run over many pairs must contain to be meaningful.
struct Expected {
  double least_hits, most_hits;  ///< shares of all pairs
  double exact_signs;            ///< per pair, at least
};

class Tally {
 public:
  explicit Tally(std::uint64_t seed) : seed_(seed), exact_before_(detail::exact_sign_count()) {}

  /// Returns false on a mismatch.
  bool add(const TriangleCorners& a, const TriangleCorners& b, bool expected) {
    ++pairs_;
    hits_ += expected;
    EXPECT_EQ(triangles_intersect(a, b), expected)
        << "pair " << pairs_ << " of seed " << seed_ << ": " << to_text(a) << " " << to_text(b);
    return !testing::Test::HasFailure();
  }

  void check(const Expected& expected) const {
    const double share = static_cast<double>(hits_) / static_cast<double>(pairs_);
    const double exact = static_cast<double>(detail::exact_sign_count() - exact_before_) /
                         static_cast<double>(pairs_);
    EXPECT_GE(share, expected.least_hits);
    EXPECT_LE(share, expected.most_hits);
    EXPECT_GE(exact, expected.exact_signs);
  }

 private:
  std::uint64_t seed_, exact_before_;
  std::uint64_t pairs_ = 0, hits_ = 0;
};

template <typename Integer>
IntegerTriangle<Integer> widened(const IntegerCorners& corners) {
  IntegerTriangle<Integer> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) result[i][axis] = corners[i][axis];
  }
  return result;
}

/// The smallest floats are multiples of 2^-149 (below 2^-126 they are subnormal); the largest are
/// multiples of 2^104.
constexpr int kSmallest = -149, kOne = -24, kLargest = 104;

template <typename Integer>
void compare(IntegerPair (*make)(Random&), std::uint64_t seed, int pairs,
             const Expected& expected) {
  Random random(seed);
  Tally tally(seed);
  for (int i = 0; i < pairs; ++i) {
    const IntegerPair pair = make(random);
    const bool meet = !have_disjoint_boxes(pair.a, pair.b) &&
                      hulls_meet(widened<Integer>(pair.a), widened<Integer>(pair.b));
    const int exponent = std::array{kOne, kSmallest, kLargest}[random() % 3];
    if (!tally.add(scaled(pair.a, exponent), scaled(pair.b, exponent), meet)) return;
  }
  tally.check(expected);
}

TEST(TrianglePairExact, Anywhere) { compare<Int128>(anywhere, 1, 400'000, {0.1, 0.9, 0.01}); }

TEST(TrianglePairExact, OnGrid) { compare<std::int64_t>(on_grid, 2, 1'000'000, {0.1, 0.9, 0.1}); }

TEST(TrianglePairExact, InOnePlane) {
  compare<std::int64_t>(in_plane, 3, 400'000, {0.1, 0.9, 0.1});
}

TEST(TrianglePairExact, Collapsed) {
  compare<std::int64_t>(collapsed, 4, 800'000, {0.05, 0.9, 0.1});
}

TEST(TrianglePairExact, NearlyCoplanar) {
  compare<Int128>(nearly_coplanar, 5, 300'000, {0.1, 0.9, 0.01});
}

TEST(TrianglePairExact, ShearedGrid) { compare<Int128>(sheared_grid, 9, 300'000, {0.1, 0.9, 0.5}); }

TEST(TrianglePairExact, Slivers) { compare<Int128>(slivers, 6, 300'000, {0.05, 0.9, 0.01}); }

IntegerTriangle<float> coordinates(const TriangleCorners& corners) {
  IntegerTriangle<float> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = {corners[i].x, corners[i].y, corners[i].z};
  return result;
}

IntegerTriangle<mpz_class> exact(const TriangleCorners& corners) {
  const auto integer = [](float x) { return mpz_class(std::ldexp(double{x}, -kSmallest)); };
  IntegerTriangle<mpz_class> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = {integer(corners[i].x), integer(corners[i].y), integer(corners[i].z)};
  }
  return result;
}

void compare_floats(float (*coordinate)(Random&), std::uint64_t seed, int pairs,
                    const Expected& expected) {
  Random random(seed);
  Tally tally(seed);
  for (int i = 0; i < pairs; ++i) {
    const TriangleCorners a = corners_of(random, coordinate), b = corners_of(random, coordinate);
    const bool meet =
        !have_disjoint_boxes(coordinates(a), coordinates(b)) && hulls_meet(exact(a), exact(b));
    if (!tally.add(a, b, meet)) return;
  }
  tally.check(expected);
}

TEST(TrianglePairExact, AnyFiniteBitPattern) {
  compare_floats(any_finite_float, 7, 60'000, {0.02, 0.9, 0.0001});
}

TEST(TrianglePairExact, FewFloatsOfAllMagnitudes) {
  compare_floats(one_of_few_floats, 8, 60'000, {0.05, 0.9, 0.01});
}

}  // namespace
}  // namespace pelt::test
