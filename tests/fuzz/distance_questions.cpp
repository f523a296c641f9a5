#include "fuzz/goal.hpp"
#include "fuzz/pair_oracle.hpp"
#include "fuzz/questions.hpp"
#include "geometry/exact_distance.hpp"
#include "support/require.hpp"

#include <pelt/distance.hpp>

#include <algorithm>

namespace pelt::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Goal bodies_apart("distance: apart"), bodies_touching("distance: touching"),
    near_pairs_found("clearance: pairs that are near and do not touch"),
    no_near_pair("clearance: no pair"), touching_pairs("clearance: touching pairs"),
    triangles_apart("the distance of two triangles"), closest_points_asked("closest_point");

LeastDistance least_distance_of(const Question& q) {
  return least_distance(q.a.all_corners(), q.b.all_corners());
}

void check_answer(const Distance& found, const LeastDistance& expected) {
  require(found.distance == expected.distance, "distance");
  require(found.lower_bound == expected.distance, "the lower bound of distance");
  require(found.a.triangle == expected.triangle_a && found.b.triangle == expected.triangle_b,
          "the triangles of distance");
}

/// The least distance is within a maximum of that distance, and beyond any lower one.
void check_maximum(Question& q, const LeastDistance& expected) {
  Distance found;
  distance(q.a.pose, q.b.pose, q.scratch, found, {.max_distance = expected.distance});
  check_answer(found, expected);
  if (expected.distance == 0) return;
  const double less = std::nextafter(expected.distance, 0.0);
  distance(q.a.pose, q.b.pose, q.scratch, found, {.max_distance = less});
  require(!found && found.lower_bound == less, "max_distance");
}

void check_tolerance(Question& q, const LeastDistance& expected) {
  const double tolerance = double{q.bytes.size()};
  Distance found;
  distance(q.a.pose, q.b.pose, q.scratch, found, {.tolerance = tolerance});
  require(found.lower_bound <= expected.distance && expected.distance <= found.distance,
          "the bounds of a distance with a tolerance");
  require(found.distance <= (expected.distance + tolerance) * (1 + 1e-12),
          "a distance with a tolerance");
}

/// Zero, any number, the least distance, or just below it.
double make_tolerance(Question& q) {
  switch (q.bytes.index(4)) {
    case 0:
      return double{q.bytes.size()};
    case 1:
      return least_distance_of(q).distance;
    case 2:
      return std::nextafter(least_distance_of(q).distance, 0.0);
    default:
      return distance_of(q.a.corners(q.bytes.index(q.a.triangle_count())),
                         q.b.corners(q.bytes.index(q.b.triangle_count())));
  }
}

std::vector<Contact> near_pairs(const Question& q, double tolerance) {
  const auto a = q.a.all_corners(), b = q.b.all_corners();
  std::vector<Contact> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j)
      if (distance_of(a[i], b[j]) <= tolerance) pairs.push_back({i, j});
  return pairs;
}

void check_limit(Question& q, double tolerance, const std::vector<Contact>& expected) {
  const std::uint32_t limit = q.bytes.index(8);
  std::vector<Contact> some;
  const QueryStats work =
      clearance(q.a.pose, q.b.pose, tolerance, q.scratch, some, {.max_contacts = limit});
  require(some.size() == std::min<std::size_t>(limit, expected.size()), "max_pairs");
  require(std::includes(expected.begin(), expected.end(), some.begin(), some.end()),
          "a pair within max_pairs");
  require(work.cut_short == (some.size() < expected.size()), "cut_short of clearance");
}

double axis_gap(const detail::TriangleCorners& a, const detail::TriangleCorners& b,
                float Vec3::*axis) {
  const auto [low_a, high_a] = std::minmax({a[0].*axis, a[1].*axis, a[2].*axis});
  const auto [low_b, high_b] = std::minmax({b[0].*axis, b[1].*axis, b[2].*axis});
  return std::max({double{low_a} - double{high_b}, double{low_b} - double{high_a}, 0.0});
}

/// The squared distance of the boxes of two triangles.
double squared_box_gap(const detail::TriangleCorners& a, const detail::TriangleCorners& b) {
  const double x = axis_gap(a, b, &Vec3::x), y = axis_gap(a, b, &Vec3::y),
               z = axis_gap(a, b, &Vec3::z);
  return x * x + y * y + z * z;
}

/// The largest difference of two coordinates on an axis.
double extent_of(std::span<const Vec3> points) {
  double most = 0;
  for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [&](const Vec3& p, const Vec3& q) { return p.*axis < q.*axis; });
    most = std::max(most, double{(*high).*axis} - double{(*low).*axis});
  }
  return most;
}

}  // namespace

void ask_distance(Question& q) {
  const LeastDistance expected = least_distance_of(q);
  Distance found, again;
  distance(q.a.pose, q.b.pose, q.scratch, found);
  check_answer(found, expected);
  distance(q.a.pose, q.b.pose, q.scratch, again, {.hint = &found});
  check_answer(again, expected);
  check_maximum(q, expected);
  check_tolerance(q, expected);
  (found.distance > 0 ? bodies_apart : bodies_touching).reach();
}

void ask_clearance(Question& q) {
  const double tolerance = make_tolerance(q);
  const std::vector<Contact> expected = near_pairs(q, tolerance);
  std::vector<Contact> found;
  clearance(q.a.pose, q.b.pose, tolerance, q.scratch, found);
  require(found == expected, "clearance");
  require(
      static_cast<bool>(is_within(q.a.pose, q.b.pose, tolerance, q.scratch)) == !expected.empty(),
      "is_within");
  check_limit(q, tolerance, expected);
  const auto contacts = intersecting_pairs(q.a.all_corners(), q.b.all_corners());
  near_pairs_found.reach(expected.size() > contacts.size());
  no_near_pair.reach(expected.empty());
  touching_pairs.reach(!contacts.empty());
}

/// The definition of the distance of two triangles, and of a point, against rational numbers.
void ask_triangle_distance(Question& q) {
  const detail::TriangleCorners a = q.a.corners(q.bytes.index(q.a.triangle_count()));
  const detail::TriangleCorners b = q.b.corners(q.bytes.index(q.b.triangle_count()));
  const double to_point =
      std::sqrt(detail::closest_on_triangle(detail::Vec3d(a[0]), b).squared_distance);
  const double exact_to_point = root(point_triangle(exact(a[0]), exact(b)));
  const std::array<Vec3, 4> point_and_b = {a[0], b[0], b[1], b[2]};
  require(std::abs(to_point - exact_to_point) <= detail::kDistanceError * extent_of(point_and_b),
          "the distance of a point from a triangle");
  if (detail::triangles_intersect(a, b)) return;
  const double squared = detail::closest_points(a, b).squared_distance;
  const double exact_distance = root(triangle_triangle(exact(a), exact(b)));
  const std::array<Vec3, 6> both = {a[0], a[1], a[2], b[0], b[1], b[2]};
  require(std::abs(std::sqrt(squared) - exact_distance) <= detail::kDistanceError * extent_of(both),
          "the distance of two triangles");
  require(squared >= squared_box_gap(a, b) * (1 - 0x1p-19) - 0x1p-119,
          "two triangles are nearer than their boxes");
  triangles_apart.reach();
}

void ask_closest_point(Question& q) {
  const Vec3 point = point_near(q.bytes, q.b);
  double least = kInfinity;
  std::uint32_t triangle = 0;
  for (std::uint32_t t = 0; t < q.a.triangle_count(); ++t) {
    const double squared =
        detail::closest_on_triangle(detail::Vec3d(point), q.a.corners(t)).squared_distance;
    if (squared < least) least = squared, triangle = t;
  }
  ClosestPoint closest;
  closest_point(q.a.pose, point, q.scratch, closest);
  require(closest.distance == std::sqrt(least) && closest.point.triangle == triangle,
          "closest_point");
  const Vec3 points[] = {point, point_near(q.bytes, q.a)};
  ClosestPoint each[2];
  closest_points(q.a.pose, points, q.scratch, each, {.max_distance = std::sqrt(least)});
  require(each[0].distance == std::sqrt(least) && each[0].point.triangle == triangle,
          "closest_points");
  require(each[1].distance <= std::sqrt(least) || !each[1], "max_distance of closest_points");
  closest_points_asked.reach();
}

}  // namespace pelt::test
