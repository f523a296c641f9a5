/// Lower bounds of distances against the distance in rational numbers.
#include "self/neighbour_gaps.hpp"

#include "geometry/exact_distance.hpp"
#include "geometry/triage_lanes.hpp"
#include "geometry/triangle_cases.hpp"
#include "separation_lanes.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <iostream>

namespace pelt::test {
namespace {

using detail::TriangleCorners;
using detail::triangles_intersect;

/// The same bounds on every instruction set.
LaneSeparations separations_of(const TriangleCorners& a, const TriangleCorners& b) {
  static LaneCorners lanes;
  fill(lanes, turned(a, b));
  constexpr Compiled<SeparationLanes> kSeparations[] = PELT_ALL_COMPILED(separation_lanes);
  return on_each_compiled(kSeparations, lanes);
}

/// Returns how many of the pairs that do not touch have a positive bound, in per cent.
int separated_share(IntegerPair (*make)(Random&), std::uint64_t seed) {
  Random random(seed);
  int apart = 0, separated = 0;
  for (int i = 0; i < 1500; ++i) {
    const IntegerPair pair = make(random);
    const int exponent = i % 3 == 0 ? -24 : i % 3 == 1 ? 30 : -110;
    const TriangleCorners a = scaled(pair.a, exponent), b = scaled(pair.b, exponent);
    const bool touches = triangles_intersect(a, b);
    const mpq_class squared = touches ? mpq_class(0) : triangle_triangle(exact(a), exact(b));
    bool is_separated = false;
    for (const float bound : separations_of(a, b)) {
      EXPECT_GE(bound, 0) << to_text(a) << to_text(b);
      EXPECT_LE(mpq_class(bound) * mpq_class(bound), squared) << to_text(a) << to_text(b);
      is_separated = is_separated || bound > 0;
    }
    if (::testing::Test::HasFailure()) break;
    apart += !touches, separated += is_separated;
  }
  std::cout << "seed " << seed << ": " << separated << " of " << apart << " apart are separated\n";
  return apart == 0 ? 0 : 100 * separated / apart;
}

TEST(TriangleSeparation, Anywhere) { EXPECT_GT(separated_share(anywhere, 70), 50); }
TEST(TriangleSeparation, OnGrid) { EXPECT_GT(separated_share(on_grid, 71), 50); }
TEST(TriangleSeparation, InOnePlane) { EXPECT_GT(separated_share(in_plane, 72), 50); }
TEST(TriangleSeparation, NearlyCoplanar) { EXPECT_GT(separated_share(nearly_coplanar, 73), 0); }
TEST(TriangleSeparation, ShearedGrid) { EXPECT_GT(separated_share(sheared_grid, 74), 10); }
TEST(TriangleSeparation, Slivers) { EXPECT_GT(separated_share(slivers, 75), 0); }
TEST(TriangleSeparation, Collapsed) { EXPECT_GT(separated_share(collapsed, 76), 0); }

/// Squares that overflow or underflow give no bound.
TEST(TriangleSeparation, OfHugeAndTinyTriangles) {
  for (const float size : {0x1p58f, 0x1p40f, 1.0f, 0x1p-40f, 0x1p-70f, 0x1p-140f}) {
    const TriangleCorners a = {Vec3{0, 0, 0}, Vec3{size, 0, 0}, Vec3{0, size, 0}};
    const TriangleCorners b = {Vec3{0, 0, size}, Vec3{size, 0, size}, Vec3{0, size, size}};
    for (const float bound : separations_of(a, b)) {
      EXPECT_GE(bound, 0);
      EXPECT_LE(bound, size);
      if (size == 1) {
        EXPECT_GT(bound, 0.999f);
      }
    }
  }
}

}  // namespace
}  // namespace pelt::test
