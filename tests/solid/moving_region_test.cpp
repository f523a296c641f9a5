/// A moving triangle against regions, by an independent method with numbers of GMP. The environment
/// variable PELT_MOVING_REGIONS sets the number of cases per family.
#include "solid/region_triangle.hpp"

#include "moving_region_oracle.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace pelt::test {
namespace {

using detail::CertainAnswer;
using detail::Face;
using detail::FirstTouch;
using detail::MovingTriangle;
using detail::TrianglePlace;

/// Where coordinates come from.
struct Family {
  const char* name;
  float (*coordinate)(Random&);
  int cases;  ///< fewer where the independent method is slow
};

int cases_of(const Family& family) {
  const char* text = std::getenv("PELT_MOVING_REGIONS");
  return text == nullptr ? family.cases : std::atoi(text);
}

float on_small_grid(Random& random) { return static_cast<float>(random.index(7)) - 3; }

float in_general_position(Random& random) { return random.uniformf(-3, 3); }

float on_all_scales(Random& random) {
  const float fraction = random.uniformf(-1, 1);
  const auto exponent = static_cast<int>(random.index(100)) - 50;
  return random.chance(0.2) ? 0.0f : std::ldexp(fraction, exponent);
}

/// A coordinate with as many bits as possible.
float on_extreme_scales(Random& random) {
  const float fraction = random.uniformf(-1, 1);
  return std::ldexp(fraction, random.chance(0.5) ? -125 - static_cast<int>(random.index(24)) : 60);
}

constexpr Family kFamilies[] = {{"SmallGrid", on_small_grid, 300},
                                {"GeneralPosition", in_general_position, 200},
                                {"AllScales", on_all_scales, 40},
                                {"ExtremeScales", on_extreme_scales, 25}};

class Maker {
 public:
  Maker(Random& random, const Family& family) : random_(random), family_(family) {}

  Vec3 point() {
    const float x = number(), y = number(), z = number();
    return {x, y, z};
  }

  float number() { return family_.coordinate(random_); }

  /// Still, moved without a turn, with some still corners, collapsed, or any.
  MovingTriangle triangle() {
    MovingTriangle t{{point(), point(), point()}, {point(), point(), point()}};
    const auto kind = random_.index(8);
    if (kind == 0) t.to = t.from;
    if (kind == 1) t.to[0] = t.from[0], t.to[1] = t.from[1];
    if (kind == 2) t.from[1] = t.from[0], t.to[1] = t.to[0];
    if (kind == 3) t.from[2] = t.from[1] = t.from[0], t.to[2] = t.to[1] = t.to[0];
    if (kind == 4)
      for (std::size_t k = 0; k < 3; ++k) t.from[k].y = t.to[k].y = t.from[0].y;
    if (kind == 5) t.from[2] = t.from[1] = t.from[0];
    return t;
  }

  std::vector<Face> faces() {
    std::vector<Face> faces(1 + random_.index(5));
    for (Face& face : faces) {
      face = {point(), point(), std::fabs(number())};
      if (random_.chance(0.3)) face.normal = {0, face.normal.x, 0};
      if (random_.chance(0.5)) face.origin = {};
    }
    return faces;
  }

  /// A sphere, a capsule, a segment or a point, often parallel to an axis.
  Capsule capsule() {
    Capsule capsule{point(), point(), std::fabs(number())};
    if (random_.chance(0.3)) capsule.b = capsule.a;
    if (random_.chance(0.3)) capsule.b.x = capsule.a.x, capsule.b.y = capsule.a.y;
    if (random_.chance(0.2)) capsule.radius = 0;
    return capsule;
  }

 private:
  Random& random_;
  const Family& family_;
};

MovingTriangle reversed(const MovingTriangle& t) { return {t.to, t.from}; }

std::string to_text(const std::optional<FirstTouch>& touch) {
  if (!touch) return "never";
  return touch->at_start ? "at the start" : std::to_string(touch->time);
}

struct Counts {
  int at_start = 0, later = 0, never = 0;
  int certain = 0, certain_times = 0;  // of those not at the start

  void add(const std::optional<FirstTouch>& touch) {
    ++(!touch ? never : touch->at_start ? at_start : later);
  }

  void expect_many(int cases) const {
    EXPECT_GT(at_start, cases / 50);
    EXPECT_GT(later, cases / 25);
    EXPECT_GT(never, cases / 25);
    EXPECT_GT(certain, (later + never) / 3);
    EXPECT_GT(certain_times, (later + never) / 3);
  }
};

/// Expects that answers which are certain in double equal the exact answer.
template <typename AnyRegion>
void expect_certain(const MovingTriangle& triangle, const AnyRegion& region,
                    const std::optional<FirstTouch>& expected, Counts& counts) {
  const CertainAnswer answer = detail::certainly_touches(triangle, region);
  if (answer != CertainAnswer::unknown) {
    ASSERT_EQ(answer == CertainAnswer::yes, expected.has_value());
    ++counts.certain;
  }
  std::optional<FirstTouch> touch;
  if (detail::find_certain_first_touch(triangle, region, touch)) {
    ASSERT_EQ(touch, expected) << to_text(touch) << " instead of " << to_text(expected);
    ++counts.certain_times;
  }
}

/// `Oracle`: FacesOracle or CapsuleOracle.
template <typename Oracle, typename AnyRegion>
void expect_as_oracle(const MovingTriangle& triangle, const AnyRegion& region, Counts& counts) {
  const auto touch = detail::first_touch(triangle, region);
  const auto expected = Oracle(triangle, region).first_touch();
  ASSERT_EQ(touch, expected) << to_text(touch) << " instead of " << to_text(expected);
  ASSERT_EQ(touch.has_value(), detail::first_touch(reversed(triangle), region).has_value());
  if (detail::place_triangle(triangle.to, region) != TrianglePlace::apart) {
    ASSERT_TRUE(touch.has_value());
  }
  counts.add(touch);
  if (!touch || !touch->at_start) expect_certain(triangle, region, touch, counts);
}

class MovingRegion : public testing::TestWithParam<Family> {};

TEST_P(MovingRegion, TouchesFacesAsByAnIndependentMethod) {
  Random random(1861);
  Maker make(random, GetParam());
  Counts counts;
  for (int i = 0; i < cases_of(GetParam()) && !HasFatalFailure(); ++i) {
    SCOPED_TRACE(i);
    const MovingTriangle triangle = make.triangle();
    expect_as_oracle<FacesOracle>(triangle, std::span<const Face>(make.faces()), counts);
  }
  counts.expect_many(cases_of(GetParam()));
}

TEST_P(MovingRegion, TouchesACapsuleAsByAnIndependentMethod) {
  Random random(1862);
  Maker make(random, GetParam());
  Counts counts;
  for (int i = 0; i < cases_of(GetParam()) && !HasFatalFailure(); ++i) {
    SCOPED_TRACE(i);
    const MovingTriangle triangle = make.triangle();
    expect_as_oracle<CapsuleOracle>(triangle, make.capsule(), counts);
  }
  counts.expect_many(cases_of(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Families, MovingRegion, testing::ValuesIn(kFamilies),
                         [](const auto& family) { return std::string(family.param.name); });

}  // namespace
}  // namespace pelt::test
