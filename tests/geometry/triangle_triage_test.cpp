#include <pelt/config.hpp>

#include "base/hash.hpp"
#include "exact/finite_floats.hpp"
#include "exact/predicates.hpp"
#include "geometry/triangle_pair.hpp"
#include "support/instruction_sets.hpp"
#include "triage_lanes.hpp"
#include "triangle_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace pelt::test {
namespace {

using detail::TriangleCorners;
using detail::triangles_intersect;

struct TestedPair {
  TriangleCorners a, b;
};

// Generators without the distributions of the standard library, which differ between
// implementations: the golden hash needs the same pairs everywhere.

/// From -1 to 1, a multiple of 2^-23.
float unit(Random& random) { return static_cast<float>(random() >> 40) * 0x1p-23f - 1; }

Vec3 near(Random& random, const Vec3& center, float radius) {
  return {center.x + radius * unit(random), center.y + radius * unit(random),
          center.z + radius * unit(random)};
}

TriangleCorners triangle_near(Random& random, const Vec3& center, float radius) {
  return {near(random, center, radius), near(random, center, radius), near(random, center, radius)};
}

/// Triangles of about a centimetre, less than a centimetre apart.
TestedPair close_at(Random& random, float distance) {
  const Vec3 center = near(random, {distance, distance, distance}, distance / 2);
  return {triangle_near(random, center, 0.007f),
          triangle_near(random, near(random, center, 0.008f), 0.007f)};
}

TestedPair close_at_0(Random& random) { return close_at(random, 0); }
TestedPair close_at_1(Random& random) { return close_at(random, 1); }
TestedPair close_at_10(Random& random) { return close_at(random, 10); }
TestedPair close_at_1000(Random& random) { return close_at(random, 1000); }

template <int kExponent>
TestedPair of_size(Random& random) {
  const float radius = std::ldexp(0.5f, kExponent);
  return {triangle_near(random, {}, radius), triangle_near(random, {}, radius)};
}

float within_limit(Random& random) {
  while (true) {
    const float value = any_finite_float(random);
    if (std::fabs(value) <= 0x1p60f) return value;
  }
}

TestedPair any_exponents(Random& random) {
  return {corners_of(random, within_limit), corners_of(random, within_limit)};
}

/// From 2^low to 2^(low + count - 1).
float power_of_two(Random& random, int low, unsigned count) {
  return std::ldexp(1.0f, low + static_cast<int>(random() % count));
}

/// In the first triangle, two vertices are 2^6 to 2^13 times closer to each other than to the
/// third.
TestedPair needle(Random& random) {
  TestedPair pair = close_at_0(random);
  pair.a[1] = near(random, pair.a[2], 0.01f * power_of_two(random, -13, 8));
  return pair;
}

/// A rounded point of the triangle's plane, inside or near the triangle.
Vec3 in_plane_of(Random& random, const TriangleCorners& t) {
  const float u = unit(random), v = unit(random), w = 1 - u - v;
  return {w * t[0].x + u * t[1].x + v * t[2].x, w * t[0].y + u * t[1].y + v * t[2].y,
          w * t[0].z + u * t[1].z + v * t[2].z};
}

/// The second triangle is 2^4 to 2^11 times smaller than the first and near its plane.
TestedPair large_and_small(Random& random) {
  const TriangleCorners large = triangle_near(random, {}, 1);
  const float size = power_of_two(random, -11, 8);
  const Vec3 center = near(random, in_plane_of(random, large), size / 2);
  return {large, triangle_near(random, center, size)};
}

/// The vertices of the second triangle are off the first one's plane by 2^-6 to 2^-25 of its size,
/// where signs start to be uncertain.
TestedPair almost_coplanar(Random& random) {
  const TriangleCorners t = triangle_near(random, {}, 1);
  const auto off_plane = [&] {
    const Vec3 on_plane = in_plane_of(random, t);
    return near(random, on_plane, power_of_two(random, -25, 20));
  };
  return {t, {off_plane(), off_plane(), off_plane()}};
}

/// An edge of the second triangle passes an edge of the first at a distance of 2^-6 to 2^-25 of its
/// length.
TestedPair almost_touching(Random& random) {
  const TriangleCorners t = triangle_near(random, {}, 1);
  const Vec3 middle = {(t[0].x + t[1].x) / 2, (t[0].y + t[1].y) / 2, (t[0].z + t[1].z) / 2};
  const Vec3 end = near(random, middle, 1);
  const Vec3 beyond = {2 * middle.x - end.x, 2 * middle.y - end.y, 2 * middle.z - end.z};
  return {t, {near(random, end, power_of_two(random, -25, 20)), beyond, near(random, middle, 1)}};
}

template <IntegerPair (*make)(Random&)>
TestedPair integers(Random& random) {
  const IntegerPair pair = make(random);
  const int exponent = static_cast<int>(random() % 40) - 30;
  return {scaled(pair.a, exponent), scaled(pair.b, exponent)};
}

/// In general position with small integers, so few pairs touch.
IntegerPair on_wide_grid(Random& random) {
  return {uniform_corners(random, 0, 30), uniform_corners(random, 0, 30)};
}

/// In every other pair, a vertex of the second triangle is at a vertex of the first or in the
/// middle of an edge.
IntegerPair touching(Random& random) {
  IntegerPair pair = {uniform_corners(random, -500, 500), uniform_corners(random, -500, 500)};
  for (Point& p : pair.a) p = 2 * p;
  if (random() % 2) pair.b[random() % 3] = random() % 2 ? middle(pair.a[0], pair.a[1]) : pair.a[2];
  return pair;
}

struct Case {
  const char* name;
  TestedPair (*make)(Random&);
  double least_undecided, most_undecided, least_intersecting;  ///< shares; the last of the decided

  friend void PrintTo(const Case& tested, std::ostream* out) { *out << tested.name; }
};

constexpr Case kCases[] = {
    {"CloseAtOrigin", close_at_0, 0, 0.005, 0.05},
    {"CloseAt1", close_at_1, 0, 0.005, 0.05},
    {"CloseAt10", close_at_10, 0, 0.005, 0.05},
    {"CloseAt1000", close_at_1000, 0, 0.005, 0.05},
    {"Needle", needle, 0, 0.05, 0.01},
    {"LargeAndSmall", large_and_small, 0.01, 0.6, 0.05},
    {"AlmostCoplanar", almost_coplanar, 0.1, 0.9, 0.05},
    {"AlmostTouching", almost_touching, 0.1, 0.9, 0.05},
    {"Large", of_size<30>, 0, 0.005, 0.1},
    {"LargestProducts", of_size<41>, 0.001, 0.999, 0.1},
    {"Overflowing", of_size<61>, 1, 1, 0},
    {"Small", of_size<-20>, 0, 0.005, 0.1},
    {"SmallestProducts", of_size<-26>, 0.01, 0.99, 0.01},
    {"Underflowing", of_size<-50>, 1, 1, 0},
    {"Denormal", of_size<-130>, 1, 1, 0},
    {"AnyExponents", any_exponents, 0.5, 0.99, 0},
    {"AnyIntegers", integers<anywhere>, 0, 0.2, 0.05},
    {"WideGrid", integers<on_wide_grid>, 0.001, 0.1, 0.05},
    {"Grid", integers<on_grid>, 0.2, 0.9, 0.01},
    {"InOnePlane", integers<in_plane>, 1, 1, 0},
    {"Touching", integers<touching>, 0.2, 0.9, 0.01},
    {"Collapsed", integers<collapsed>, 0.5, 1, 0},
    {"NearlyCoplanar", integers<nearly_coplanar>, 0.9, 1, 0},
    {"ShearedGrid", integers<sheared_grid>, 0.2, 1, 0},
    {"Slivers", integers<slivers>, 0.2, 1, 0},
};

constexpr Compiled<TriageLanes> kTriage[] = PELT_ALL_COMPILED(triage_lanes);

void put(const TriangleCorners& triangle, float (&corners)[3][8][4], std::size_t lane) {
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i][lane][0] = triangle[i].x;
    corners[i][lane][1] = triangle[i].y;
    corners[i][lane][2] = triangle[i].z;
    corners[i][lane][3] = 0;
  }
}

/// Counts of decisions over many pairs.
struct Tally {
  int pairs = 0, apart = 0, intersecting = 0;
  std::uint64_t exact_signs = 0;  ///< needed by undecided pairs

  void add(const TestedPair& pair, bool is_apart, bool is_intersecting) {
    ++pairs;
    apart += is_apart;
    intersecting += is_intersecting;
    const std::uint64_t before = detail::exact_sign_count();
    const bool intersect = triangles_intersect(pair.a, pair.b);
    if (!is_apart && !is_intersecting) exact_signs += detail::exact_sign_count() - before;
    EXPECT_FALSE(is_apart && intersect) << to_text(pair.a) << to_text(pair.b);
    EXPECT_FALSE(is_intersecting && !intersect) << to_text(pair.a) << to_text(pair.b);
  }

  double undecided_share() const { return 1 - 1.0 * (apart + intersecting) / pairs; }
};

/// Eight pairs from a generator, in both orders.
struct Batch {
  std::array<TestedPair, 8> pairs;
  LaneCorners forth, back;

  Batch(Random& random, TestedPair (*make)(Random&)) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      pairs[lane] = make(random);
      put(pairs[lane].a, forth[0], lane);
      put(pairs[lane].b, forth[1], lane);
      put(pairs[lane].b, back[0], lane);
      put(pairs[lane].a, back[1], lane);
    }
  }

  void tally(const LaneMasks& masks, Tally& result) const {
    for (std::size_t lane = 0; lane < 8; ++lane)
      result.add(pairs[lane], masks.apart >> lane & 1, masks.intersecting >> lane & 1);
  }
};

class TriangleTriage : public testing::TestWithParam<Case> {};

TEST_P(TriangleTriage, DecidesAsTheExactTest) {
  Random random = seeded(61);
  Tally tally;
  for (int i = 0; i < 2'000 && !HasFailure(); ++i) {
    const Batch batch(random, GetParam().make);
    for (const LaneCorners* corners : {&batch.forth, &batch.back}) {
      batch.tally(on_each_compiled(kTriage, *corners), tally);
    }
  }
  EXPECT_GE(tally.undecided_share(), GetParam().least_undecided);
  EXPECT_LE(tally.undecided_share(), GetParam().most_undecided);
  EXPECT_GE(tally.intersecting, GetParam().least_intersecting * (tally.apart + tally.intersecting));
}

INSTANTIATE_TEST_SUITE_P(All, TriangleTriage, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(TriangleTriageMasks, AreTheSameForEveryTargetAndCompiler) {
  constexpr std::uint64_t kGolden = 0xce7758364713cc68u;
  for (const auto& [set, triage] : kTriage) {
    if (!runs_here(set)) continue;
    Random random = seeded(62);
    detail::Fnv1a64 hash;
    for (int i = 0; i < 2'000; ++i) {
      for (const auto make : {close_at_0, close_at_1000, needle, almost_coplanar, almost_touching,
                              of_size<41>, of_size<-26>}) {
        const LaneMasks masks = triage(Batch(random, make).forth);
        hash.add_u32(masks.apart << 8 | masks.intersecting);
      }
    }
    EXPECT_EQ(hash.value(), kGolden) << name_of(set);
  }
}

TEST(TriangleTriageMasks, LeaveTheExactStageItsWork) {
  Random random = seeded(63);
  Tally tally;
  for (int i = 0; i < 500; ++i) {
    const Batch batch(random, integers<on_grid>);
    batch.tally(scalar::triage_lanes(batch.forth), tally);
  }
  EXPECT_GT(tally.exact_signs, 1'000u);
}

}  // namespace
}  // namespace pelt::test
