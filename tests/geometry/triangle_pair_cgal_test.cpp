/// The triangle pair test against CGAL's exact predicates, on triangles that are not collapsed
/// (CGAL accepts no others).
#include "geometry/triangle_pair.hpp"

#include "exact/finite_floats.hpp"
#include "exact/predicates.hpp"
#include "triangle_cases.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

namespace pelt::test {
namespace {

using detail::TriangleCorners;
using detail::triangles_intersect;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Triangle_3 cgal(const TriangleCorners& corners) {
  const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return {point(corners[0]), point(corners[1]), point(corners[2])};
}

/// Compares `pairs` pairs from `make`. Skips pairs with a collapsed triangle, which must be less
/// than half. Expects the exact stage to have run at least `exact_signs` times.
template <typename Make>
void compare_with_cgal(const Make& make, std::uint64_t seed, int pairs, std::uint64_t exact_signs) {
  Random random(seed);
  const std::uint64_t exact_before = detail::exact_sign_count();
  int hits = 0, compared = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = make(random);
    const Kernel::Triangle_3 cgal_a = cgal(a), cgal_b = cgal(b);
    if (cgal_a.is_degenerate() || cgal_b.is_degenerate()) continue;
    const bool expected = CGAL::do_intersect(cgal_a, cgal_b);
    ASSERT_EQ(triangles_intersect(a, b), expected)
        << "pair " << i << " of seed " << seed << ": " << to_text(a) << to_text(b);
    ++compared;
    hits += expected;
  }
  const std::uint64_t exact = detail::exact_sign_count() - exact_before;
  EXPECT_GT(compared, pairs / 2);
  EXPECT_GT(hits, compared / 20);
  EXPECT_LT(hits, compared * 19 / 20);
  EXPECT_GE(exact, exact_signs);
}

using FloatPair = std::pair<TriangleCorners, TriangleCorners>;

void compare_integers_with_cgal(IntegerPair (*make)(Random&), std::uint64_t seed, int pairs,
                                std::uint64_t exact_signs) {
  const auto make_scaled = [make](Random& random) {
    const IntegerPair pair = make(random);
    return FloatPair(scaled(pair.a, -24), scaled(pair.b, -24));
  };
  compare_with_cgal(make_scaled, seed, pairs, exact_signs);
}

TEST(TrianglePairCgal, Anywhere) { compare_integers_with_cgal(anywhere, 41, 300'000, 1'000); }
TEST(TrianglePairCgal, OnGrid) { compare_integers_with_cgal(on_grid, 42, 300'000, 10'000); }
TEST(TrianglePairCgal, InOnePlane) { compare_integers_with_cgal(in_plane, 43, 100'000, 10'000); }
TEST(TrianglePairCgal, NearlyCoplanar) {
  compare_integers_with_cgal(nearly_coplanar, 44, 300'000, 10'000);
}
TEST(TrianglePairCgal, ShearedGrid) {
  compare_integers_with_cgal(sheared_grid, 45, 100'000, 10'000);
}
TEST(TrianglePairCgal, Slivers) { compare_integers_with_cgal(slivers, 46, 300'000, 1'000); }

TEST(TrianglePairCgal, AnyFiniteBitPattern) {
  const auto make = [](Random& random) {
    const TriangleCorners a = corners_of(random, any_finite_float);
    return FloatPair(a, corners_of(random, any_finite_float));
  };
  compare_with_cgal(make, 47, 100'000, 1'000);
}

}  // namespace
}  // namespace pelt::test
