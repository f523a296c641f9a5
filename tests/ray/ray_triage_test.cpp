/// The certain answers of the float test equal the exact ones, and all instruction sets give the
/// same answers.

#include "exact/finite_floats.hpp"
#include "geometry/ray_triangle.hpp"
#include "geometry/triangle_cases.hpp"
#include "ray_lanes.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <array>
#include <iostream>

namespace pelt::test {
namespace {

using detail::RayCrossing;
using detail::RayLine;
using detail::TriangleCorners;

constexpr Compiled<RayLanes> kRayLanes[] = PELT_ALL_COMPILED(ray_lanes);

using EightTriangles = std::array<TriangleCorners, 8>;

/// The answer of all instruction sets.
RayLaneMasks triage(const RayLine& line, const EightTriangles& triangles) {
  RayLaneCorners corners;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3& p = triangles[i][k];
      corners[k][i][0] = p.x, corners[k][i][1] = p.y, corners[k][i][2] = p.z;
      corners[k][i][3] = 0;
    }
  return on_each_compiled(kRayLanes, line.origin, line.direction, corners);
}

struct Counts {
  int missed = 0, met = 0, undecided = 0;
};

/// Expects every certain answer to be right.
void expect_right(const RayLine& line, const EightTriangles& triangles, Counts& counts) {
  const RayLaneMasks known = triage(line, triangles);
  for (std::size_t i = 0; i < 8; ++i) {
    RayCrossing crossing;
    const bool meets = detail::line_meets_triangle(line, triangles[i], crossing);
    const auto says = [&](unsigned mask) { return (mask >> i & 1) != 0; };
    if (says(known.missed)) {
      ASSERT_FALSE(meets) << to_text(triangles[i]);
      ++counts.missed;
    } else if (says(known.met_from_front | known.met_from_back)) {
      ASSERT_NE(says(known.met_from_front), says(known.met_from_back));
      RayCrossing pierced;
      const bool pierces =
          detail::line_pierces_triangle(line, triangles[i], says(known.met_from_front), pierced);
      ASSERT_EQ(pierces, meets) << to_text(triangles[i]);
      ++counts.met;
      if (!meets) continue;  // beyond all floats
      ASSERT_EQ(pierced.t, crossing.t);
      ASSERT_EQ(pierced.from_front, crossing.from_front) << to_text(triangles[i]);
      ASSERT_EQ(pierced.on_edge, crossing.on_edge) << to_text(triangles[i]);
    } else {
      ++counts.undecided;
    }
  }
}

bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

template <typename Generate>
Counts run(std::uint64_t seed, int cases, const Generate& generate) {
  std::cout << "seed " << seed << "\n";
  Random random(seed);
  Counts counts;
  for (int i = 0; i < cases && !::testing::Test::HasFatalFailure(); ++i) {
    EightTriangles triangles;
    const RayLine line = generate(random, triangles);
    if (!is_zero(line.direction)) expect_right(line, triangles, counts);
  }
  std::cout << counts.missed << " missed, " << counts.met << " met, " << counts.undecided
            << " undecided\n";
  return counts;
}

/// A ray through two vertices of the second triangles of pairs.
template <IntegerPair (*kPair)(Random&)>
RayLine through_corners(Random& random, EightTriangles& triangles) {
  const int exponent = std::array{0, -149, 36, -24}[random() % 4];
  IntegerPair pair;
  for (TriangleCorners& triangle : triangles) {
    pair = kPair(random);
    triangle = scaled(pair.a, exponent);
  }
  const TriangleCorners b = scaled(pair.b, exponent);
  return {b[0], {b[1].x - b[0].x, b[1].y - b[0].y, b[1].z - b[0].z}};
}

/// Triangles of centimetres, and a ray from metres away aimed at one of them.
RayLine at_a_body(Random& random, EightTriangles& triangles) {
  const auto unit = [&] { return static_cast<float>(random() >> 40) * 0x1p-23f - 1; };
  const auto near = [&](const Vec3& p, float r) {
    const float x = p.x + r * unit(), y = p.y + r * unit();
    return Vec3{x, y, p.z + r * unit()};
  };
  const Vec3 middle = near({0, 1, 0}, 1), eye = near(middle, 4), target = near(middle, 0.01f);
  for (TriangleCorners& triangle : triangles)
    for (Vec3& corner : triangle) corner = near(middle, 0.02f);
  return {eye, {target.x - eye.x, target.y - eye.y, target.z - eye.z}};
}

RayLine of_any_floats(Random& random, EightTriangles& triangles) {
  const auto coordinate = random() % 2 ? any_finite_float : one_of_few_floats;
  for (TriangleCorners& triangle : triangles) triangle = corners_of(random, coordinate);
  const auto [origin, direction, other] = corners_of(random, coordinate);
  return {origin, direction};
}

TEST(RayTriage, DecidesNearlyAllOfABody) {
  const Counts counts = run(41, 20'000, at_a_body);
  EXPECT_GT(counts.missed, 20'000);
  EXPECT_GT(counts.met, 20'000);
  EXPECT_LT(counts.undecided * 100, counts.missed + counts.met);
}

TEST(RayTriage, IsNeverWrongWhereAllIsClose) {
  EXPECT_GT(run(42, 10'000, through_corners<anywhere>).met, 1'000);
  EXPECT_GT(run(43, 10'000, through_corners<on_grid>).undecided, 1'000);
  EXPECT_GT(run(44, 10'000, through_corners<nearly_coplanar>).undecided, 1'000);
  EXPECT_GT(run(45, 10'000, through_corners<sheared_grid>).undecided, 1'000);
  EXPECT_GT(run(46, 10'000, through_corners<slivers>).missed, 1'000);
}

TEST(RayTriage, IsNeverWrongOfAnyFloats) {
  EXPECT_GT(run(47, 20'000, of_any_floats).undecided, 1'000);
}

}  // namespace
}  // namespace pelt::test
