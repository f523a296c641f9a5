#include "volume/perturbed_points.hpp"

#include "self/neighbours.hpp"
#include "support/random.hpp"
#include "volume/generic_crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pelt::detail {
namespace {

using test::Random;

TriangleCorners corners_of(const NumberedTriangle& t) { return {t[0].at, t[1].at, t[2].at}; }

/// Two triangles whose first `shared` corners are the same points, in any position of either.
struct Pair {
  NumberedTriangle a, b;

  template <typename MakePoint>
  Pair(Random& random, std::uint32_t shared, const MakePoint& make_point) {
    std::uint32_t number = random.index(100);
    for (std::size_t i = 0; i < 3; ++i) a[i] = {make_point(), number += 1 + random.index(100)};
    for (std::size_t i = 0; i < 3; ++i)
      b[i] = i < shared ? a[i] : NumberedPoint{make_point(), number += 1 + random.index(100)};
    std::rotate(a.begin(), a.begin() + random.index(3), a.end());
    std::rotate(b.begin(), b.begin() + random.index(3), b.end());
    if (random.chance(0.5)) std::swap(a, b);
  }
};

/// The same end, as the crossing of triangles in general position has it.
bool is_same(const SegmentEnd& end, const Piercing& piercing) {
  const int edge = piercing.is_edge_of_a ? end.a : end.b;
  const int turn = piercing.is_edge_of_a ? end.turn_a : end.turn_b;
  const int other_turn = piercing.is_edge_of_a ? end.turn_b : end.turn_a;
  return edge == piercing.edge && turn == piercing.inwards && other_turn == 0;
}

TEST(SurfaceCrossing, OfSeparateTrianglesIsThatOfTwoBodies) {
  Random random(64);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pair pair(random, 0, [&] { return random.point(1); });
    const auto found = cross_on_surface(pair.a, pair.b);
    const auto expected = cross_generic(corners_of(pair.a), corners_of(pair.b));
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) continue;
    for (std::size_t end = 0; end < 2; ++end) ASSERT_TRUE(is_same((*found)[end], (*expected)[end]));
    ++hits;
  }
  EXPECT_GT(hits, 1000);
}

TEST(SurfaceCrossing, OfTrianglesThatShareACornerStartsThere) {
  Random random(65);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pair pair(random, 1, [&] { return random.point(1); });
    const auto numbers = [](const NumberedTriangle& t) {
      return std::array{t[0].number, t[1].number, t[2].number};
    };
    const auto found = cross_on_surface(pair.a, pair.b);
    ASSERT_EQ(found.has_value(),
              surface_triangles_intersect({corners_of(pair.a), numbers(pair.a)},
                                          {corners_of(pair.b), numbers(pair.b)}));
    if (!found) continue;
    ASSERT_NE((*found)[0].is_corner(), (*found)[1].is_corner());
    const SegmentEnd& corner = (*found)[(*found)[0].is_corner() ? 0 : 1];
    ASSERT_EQ(pair.a[corner.a].number, pair.b[corner.b].number);
    ++hits;
  }
  EXPECT_GT(hits, 1000);
}

TEST(SurfaceCrossing, OfTrianglesThatShareAnEdgeIsNone) {
  Random random(66);
  const auto on_grid = [&] { return static_cast<float>(random.index(3)); };
  for (int i = 0; i < 2000; ++i) {
    const Pair pair(random, 2 + i % 2, [&] { return Vec3{on_grid(), on_grid(), on_grid()}; });
    ASSERT_FALSE(cross_on_surface(pair.a, pair.b));
  }
}

TEST(SurfaceCrossing, RunsBackwardsIfTheTrianglesAreExchanged) {
  Random random(67);
  int hits = 0;
  const auto on_grid = [&] { return static_cast<float>(random.index(3)); };
  for (int i = 0; i < 20000; ++i) {
    const Pair pair(random, random.index(2), [&] { return Vec3{on_grid(), on_grid(), on_grid()}; });
    const auto found = cross_on_surface(pair.a, pair.b), back = cross_on_surface(pair.b, pair.a);
    ASSERT_EQ(found.has_value(), back.has_value());
    if (!found) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      const SegmentEnd &there = (*found)[end], &here = (*back)[1 - end];
      ASSERT_EQ(there.turn_a, here.turn_b);
      ASSERT_EQ(there.turn_b, here.turn_a);
      ASSERT_TRUE(there.turn_a == 0 || there.a == here.b);
      ASSERT_TRUE(there.turn_b == 0 || there.b == here.a);
    }
    ++hits;
  }
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace pelt::detail
