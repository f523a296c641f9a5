/// The fuzz target of moving triangles: bytes -> two triangles at both ends of a step. The exact
/// test is compared with one in numbers of GMP (geometry/moving_oracle.hpp), and the certified
/// tests in float and in double with the exact test.

#include "fuzz/fuzzed_bodies.hpp"
#include "fuzz/goal.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_lanes.hpp"
#include "motion/moving_oracle.hpp"

#include <cstdio>
#include <cstdlib>

namespace pelt::test {
namespace {

using detail::FirstMeeting;
using detail::MovingTriangle;

Goal at_start("the triangles intersect at the start");
Goal later("the triangles meet later");
Goal at_end("the triangles meet at the end");
Goal never("the triangles never meet");
Goal certain_in_float("the float test is certain that they meet");
Goal apart_in_float("the float test is certain that they do not meet");
Goal certain_in_double("the double test is certain of the first meeting");
Goal uncertain_in_double("the double test is not certain");
Goal special_features("a corner meets a corner or an edge");

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "moving triangles: %s\n", what);
  std::abort();
}

/// Each corner stands still, moves with corner 0 of its triangle, or moves anywhere.
MovingTriangle make_triangle(FuzzBytes& bytes) {
  MovingTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.from[i] = bytes.point();
    const Vec3 &from = triangle.from[i], &from_0 = triangle.from[0], &to_0 = triangle.to[0];
    switch (bytes.index(3)) {
      case 0:
        triangle.to[i] = from;
        break;
      case 1:
        triangle.to[i] = bytes.point();
        break;
      default:
        triangle.to[i] = {from.x + (to_0.x - from_0.x), from.y + (to_0.y - from_0.y),
                          from.z + (to_0.z - from_0.z)};
    }
  }
  return triangle;
}

/// The same pair in all lanes.
void fill(LaneCorners& lanes, const detail::TriangleCorners& a, const detail::TriangleCorners& b) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const auto put = [&](std::size_t triangle, const Vec3& p) {
        float* to = lanes[triangle][k][lane];
        to[0] = p.x, to[1] = p.y, to[2] = p.z, to[3] = 0;
      };
      put(0, a[k]);
      put(1, b[k]);
    }
}

void check_float(const MovingTriangle& a, const MovingTriangle& b, bool meet) {
  MovingLanes lanes;
  fill(lanes.from, a.from, b.from);
  fill(lanes.to, a.to, b.to);
  const LaneMasks masks = scalar::moving_triage_lanes(lanes);
  expect(masks.apart == 0 || !meet, "the float test says that they do not meet");
  expect(masks.intersecting == 0 || meet, "the float test says that they meet");
  apart_in_float.reach(masks.apart != 0);
  certain_in_float.reach(masks.intersecting != 0);
}

void check_double(const MovingTriangle& a, const MovingTriangle& b,
                  const std::optional<FirstMeeting>& expected) {
  using detail::CertainAnswer;
  const CertainAnswer answer = detail::certainly_intersect(a, b);
  expect(answer == CertainAnswer::unknown || (answer == CertainAnswer::yes) == bool{expected},
         "the double test is wrong about whether they meet");
  std::optional<FirstMeeting> first;
  const bool is_certain = detail::find_certain_first_meeting(a, b, first);
  expect(!is_certain || first == expected, "the double test is wrong about the first meeting");
  (is_certain ? certain_in_double : uncertain_in_double).reach();
}

void count_goals(const std::optional<FirstMeeting>& first) {
  using Kind = FeatureKind;
  never.reach(!first);
  if (!first) return;
  at_start.reach(first->at_start);
  at_end.reach(first->time == 1);
  later.reach(!first->at_start && first->time < 1);
  special_features.reach(!first->at_start && first->a.kind != Kind::face &&
                         first->b.kind != Kind::face &&
                         (first->a.kind == Kind::corner || first->b.kind == Kind::corner));
}

void check(FuzzBytes& bytes) {
  const MovingTriangle a = make_triangle(bytes), b = make_triangle(bytes);
  const std::optional<FirstMeeting> first = detail::first_meeting(a, b);
  expect(first == MovingOracle(a, b).first_meeting(), "the exact test differs from the oracle");
  count_goals(first);
  check_float(a, b, first.has_value());
  check_double(a, b, first);
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pelt::test::FuzzBytes bytes(std::span(data, size));
  pelt::test::check(bytes);
  return 0;
}
