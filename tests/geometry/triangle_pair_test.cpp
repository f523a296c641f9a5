#include "geometry/triangle_pair.hpp"

#include "exact/finite_floats.hpp"
#include "triangle_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <ostream>
#include <string>

namespace pelt::test {
namespace {

using detail::TriangleCorners;
using detail::triangles_intersect;

constexpr std::array<std::array<std::size_t, 3>, 6> kPermutations = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

TriangleCorners reordered(const TriangleCorners& t, const std::array<std::size_t, 3>& order) {
  return {t[order[0]], t[order[1]], t[order[2]]};
}

/// The triangle with permuted axes, times `scale`.
TriangleCorners mapped(const TriangleCorners& t, const std::array<std::size_t, 3>& axes,
                       float scale) {
  TriangleCorners result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array from = {t[i].x, t[i].y, t[i].z};
    result[i] = {scale * from[axes[0]], scale * from[axes[1]], scale * from[axes[2]]};
  }
  return result;
}

void expect_same_in_any_order(const TriangleCorners& a, const TriangleCorners& b, bool expected) {
  for (const auto& order_a : kPermutations) {
    for (const auto& order_b : kPermutations) {
      const TriangleCorners p = reordered(a, order_a), q = reordered(b, order_b);
      EXPECT_EQ(triangles_intersect(p, q), expected) << to_text(p) << to_text(q);
      EXPECT_EQ(triangles_intersect(q, p), expected) << to_text(q) << to_text(p);
    }
  }
}

void expect_same_in_any_frame(const TriangleCorners& a, const TriangleCorners& b, bool expected,
                              std::initializer_list<float> scales) {
  for (const auto& axes : kPermutations) {
    for (const float scale : scales) {
      const TriangleCorners p = mapped(a, axes, scale), q = mapped(b, axes, scale);
      EXPECT_EQ(triangles_intersect(p, q), expected) << to_text(p) << to_text(q);
    }
  }
}

struct NamedPair {
  const char* name;
  TriangleCorners a, b;
  bool intersect;

  friend void PrintTo(const NamedPair& pair, std::ostream* out) { *out << pair.name; }
};

constexpr TriangleCorners kFlat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

constexpr NamedPair kNamedPairs[] = {
    // Two proper triangles in crossing planes.
    {"PiercesInside", kFlat, {{{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}}, true},
    {"PassesBeside", kFlat, {{{3, 3, -1}, {3, 3, 1}, {9, 9, 1}}}, false},
    {"LinkedByOneEdgeEach", kFlat, {{{1, -1, -1}, {1, 1, 1}, {1, -5, 3}}}, true},
    {"EndsAboveThePlane", kFlat, {{{1, 1, 1}, {2, 1, 2}, {1, 2, 2}}}, false},
    {"CornerOnFace", kFlat, {{{1, 1, 0}, {2, 1, 2}, {1, 2, 2}}}, true},
    {"CornerOnEdge", kFlat, {{{2, 2, 0}, {3, 3, 1}, {4, 4, -1}}}, true},
    {"CornerOnCorner", kFlat, {{{4, 0, 0}, {5, 1, 1}, {6, 0, -1}}}, true},
    {"CornerOnPlaneOutside", kFlat, {{{3, 3, 0}, {3, 3, 1}, {4, 4, -1}}}, false},
    {"EdgeThroughEdge", kFlat, {{{2, 0, -1}, {2, 0, 1}, {2, -5, 0}}}, true},
    {"EdgeOnFace", kFlat, {{{1, 1, 0}, {2, 1, 0}, {1, 1, 3}}}, true},
    {"EdgeOnPlaneAcross", kFlat, {{{-1, 1, 0}, {9, 1, 0}, {1, 1, 3}}}, true},
    {"EdgeOnPlaneOutside", kFlat, {{{3, 2, 0}, {2, 3, 0}, {3, 3, 3}}}, false},
    {"EdgeOnPlaneTouchesCorner", kFlat, {{{4, -1, 0}, {4, 1, 0}, {5, 0, 3}}}, true},
    {"CommonEdge", kFlat, {{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}}, true},
    {"IntervalsTouch", kFlat, {{{4, 0, -1}, {4, 0, 1}, {8, 0, 0}}}, true},
    {"IntervalsApart", kFlat, {{{5, 0, -1}, {5, 0, 1}, {8, 0, 0}}}, false},
    // Parallel and coplanar.
    {"Parallel", kFlat, {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}}, false},
    {"Identical", kFlat, kFlat, true},
    {"CoplanarInside", kFlat, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}, true},
    {"CoplanarAcross", kFlat, {{{-1, 1, 0}, {9, 1, 0}, {-1, 2, 0}}}, true},
    {"CoplanarStar", kFlat, {{{3, 3, 0}, {-1, 2, 0}, {2, -1, 0}}}, true},
    {"CoplanarCommonEdge", kFlat, {{{4, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, true},
    {"CoplanarPartOfEdge", kFlat, {{{1, 0, 0}, {2, 0, 0}, {1, -4, 0}}}, true},
    {"CoplanarCornerOnCorner", kFlat, {{{4, 0, 0}, {5, 0, 0}, {5, 1, 0}}}, true},
    {"CoplanarCornerOnEdge", kFlat, {{{2, 2, 0}, {5, 2, 0}, {5, 5, 0}}}, true},
    {"CoplanarApart", kFlat, {{{3, 2, 0}, {3, 4, 0}, {2, 3, 0}}}, false},
    // One collapsed triangle.
    {"PointOnFace", kFlat, {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}, true},
    {"PointOnCorner", kFlat, {{{0, 4, 0}, {0, 4, 0}, {0, 4, 0}}}, true},
    {"PointOnPlaneOutside", kFlat, {{{3, 3, 0}, {3, 3, 0}, {3, 3, 0}}}, false},
    {"PointAboveFace", kFlat, {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, false},
    {"SegmentPiercesInside", kFlat, {{{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}}, true},
    {"SegmentPiercesEdge", kFlat, {{{2, 2, -1}, {2, 2, 1}, {2, 2, 3}}}, true},
    {"SegmentPiercesCorner", kFlat, {{{0, 0, -1}, {0, 0, 1}, {0, 0, 1}}}, true},
    {"SegmentPassesBeside", kFlat, {{{3, 3, -1}, {3, 3, 1}, {3, 3, 1}}}, false},
    {"SegmentEndsOnFace", kFlat, {{{1, 1, 0}, {2, 2, 2}, {1, 1, 0}}}, true},
    {"SegmentEndsAboveFace", kFlat, {{{1, 1, 1}, {2, 2, 3}, {1, 1, 1}}}, false},
    {"SegmentInPlaneAcross", kFlat, {{{-1, 1, 0}, {9, 1, 0}, {4, 1, 0}}}, true},
    {"SegmentInPlaneInside", kFlat, {{{1, 1, 0}, {2, 1, 0}, {1, 1, 0}}}, true},
    {"SegmentInPlaneOutside", kFlat, {{{3, 2, 0}, {2, 3, 0}, {2, 3, 0}}}, false},
    {"SegmentOnEdge", kFlat, {{{3, 1, 0}, {1, 3, 0}, {2, 2, 0}}}, true},
    {"SegmentOnLineOfEdge", kFlat, {{{5, 0, 0}, {7, 0, 0}, {6, 0, 0}}}, false},
    // Two collapsed triangles.
    {"SegmentsCross",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{2, 0, 0}, {0, 2, 2}, {1, 1, 1}}},
     true},
    {"SegmentsSkew",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{2, 0, 0}, {0, 2, 1}, {2, 0, 0}}},
     false},
    {"SegmentsInPlaneApart",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{2, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
     false},
    {"SegmentsTouchInT",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{1, 1, 1}, {1, 0, 0}, {1, 0, 0}}},
     true},
    {"SegmentsOverlapOnLine",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{1, 1, 1}, {3, 3, 3}, {3, 3, 3}}},
     true},
    {"SegmentsMeetEndToEnd",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{2, 2, 2}, {3, 3, 3}, {2, 2, 2}}},
     true},
    {"SegmentsApartOnLine",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{3, 3, 3}, {4, 4, 4}, {3, 3, 3}}},
     false},
    {"SegmentsParallel",
     {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}},
     {{{1, 0, 0}, {3, 2, 2}, {1, 0, 0}}},
     false},
    {"PointOnSegment",
     {{{0, 0, 0}, {3, 3, 3}, {0, 0, 0}}},
     {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}},
     true},
    {"PointBesideSegment",
     {{{0, 0, 0}, {3, 3, 3}, {0, 0, 0}}},
     {{{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}},
     false},
    {"PointOnLineOfSegment",
     {{{1, 1, 1}, {3, 3, 3}, {1, 1, 1}}},
     {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
     false},
    {"PointOnPoint",
     {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}},
     {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}},
     true},
    {"PointBesidePoint",
     {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}},
     {{{1, 2, 4}, {1, 2, 4}, {1, 2, 4}}},
     false},
    {"NegativeZeroIsZero",
     {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
     {{{-0.0f, 0, -0.0f}, {0, -0.0f, 0}, {0, 0, 0}}},
     true},
};

class NamedTrianglePair : public testing::TestWithParam<NamedPair> {};

TEST_P(NamedTrianglePair, IsDecidedInAnyOrderAndFrame) {
  const auto& [name, a, b, intersect] = GetParam();
  expect_same_in_any_order(a, b, intersect);
  expect_same_in_any_frame(a, b, intersect, {1, -1, 0x1p-149f, 0x1p124f});
}

INSTANTIATE_TEST_SUITE_P(All, NamedTrianglePair, testing::ValuesIn(kNamedPairs),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(TrianglePair, OneUnitDecidesBetweenTouchingAndMissing) {
  const TriangleCorners flat = {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  const auto standing = [](float foot) {
    return TriangleCorners{{{0.25f, 0.25f, foot}, {0, 0, 2}, {1, 1, 2}}};
  };
  EXPECT_TRUE(triangles_intersect(flat, standing(1)));
  EXPECT_TRUE(triangles_intersect(flat, standing(std::nextafter(1.0f, 0.0f))));
  EXPECT_FALSE(triangles_intersect(flat, standing(std::nextafter(1.0f, 2.0f))));
}

TEST(TrianglePair, LargestFloatsDoNotOverflow) {
  constexpr float kMax = 0x1.fffffep+127f;
  const TriangleCorners a = {{{-kMax, -kMax, -kMax}, {kMax, -kMax, kMax}, {-kMax, kMax, kMax}}};
  const TriangleCorners b = {{{kMax, kMax, kMax}, {-kMax, kMax, -kMax}, {-kMax, -kMax, kMax}}};
  expect_same_in_any_order(a, b, true);
  expect_same_in_any_order(a, {{{kMax, kMax, kMax}, {kMax, kMax, 0}, {kMax, 0, kMax}}}, false);
}

/// The answer must not depend on the order of arguments and vertices, the frame, or the scale.
void expect_invariant(IntegerPair (*make)(Random&), std::uint64_t seed) {
  std::cout << "seed " << seed << "\n";
  Random random(seed);
  int hits = 0;
  constexpr int kPairs = 4'000;
  for (int i = 0; i < kPairs && !testing::Test::HasFailure(); ++i) {
    const IntegerPair pair = make(random);
    const TriangleCorners a = scaled(pair.a, 0), b = scaled(pair.b, 0);
    const bool intersect = triangles_intersect(a, b);
    hits += intersect;
    expect_same_in_any_order(a, b, intersect);
    expect_same_in_any_frame(a, b, intersect, {1, -1, 0x1p-149f, -0x1p-60f, 0x1p103f});
  }
  EXPECT_GT(hits, kPairs / 20);
  EXPECT_LT(hits, kPairs * 19 / 20);
}

TEST(TrianglePairInvariance, Anywhere) { expect_invariant(anywhere, 31); }
TEST(TrianglePairInvariance, OnGrid) { expect_invariant(on_grid, 32); }
TEST(TrianglePairInvariance, InOnePlane) { expect_invariant(in_plane, 33); }
TEST(TrianglePairInvariance, Collapsed) { expect_invariant(collapsed, 34); }
TEST(TrianglePairInvariance, NearlyCoplanar) { expect_invariant(nearly_coplanar, 35); }
TEST(TrianglePairInvariance, ShearedGrid) { expect_invariant(sheared_grid, 36); }
TEST(TrianglePairInvariance, Slivers) { expect_invariant(slivers, 37); }

TEST(TrianglePairInvariance, AnyFiniteBitPattern) {
  Random random = seeded(38);
  int hits = 0;
  for (int i = 0; i < 4'000 && !HasFailure(); ++i) {
    const TriangleCorners a = corners_of(random, any_finite_float);
    const TriangleCorners b = corners_of(random, any_finite_float);
    const bool intersect = triangles_intersect(a, b);
    hits += intersect;
    expect_same_in_any_order(a, b, intersect);
    expect_same_in_any_frame(a, b, intersect, {1, -1});
  }
  EXPECT_GT(hits, 200);
}

}  // namespace
}  // namespace pelt::test
