/// Distances of two bodies, and of a body from points, solids and fields.

#include "distance/brute_distance.hpp"
#include "field/fields.hpp"
#include "solid/solids.hpp"
#include "support/contract/query.hpp"

namespace pelt::contract {
namespace {

double largest_coordinate(const test::TriangleCorners& triangle) {
  double largest = 0;
  for (const Vec3& p : triangle)
    for (const float c : {p.x, p.y, p.z}) largest = std::max(largest, std::abs(double{c}));
  return largest;
}

/// Positions are rounded to float.
void expect_apart(const detail::Vec3d& p, const detail::Vec3d& q, double distance, double size) {
  EXPECT_NEAR(std::sqrt(squared_length(p - q)), distance, 1e-6 * size);
}

void expect_equal(const Distance& found, const test::BruteDistance& expected, const Triangles& a,
                  const Triangles& b) {
  ASSERT_EQ(found.distance, expected.distance);
  ASSERT_EQ(found.lower_bound, expected.distance);
  if (!found) return;
  ASSERT_EQ(found.a.triangle, expected.triangle_a);
  ASSERT_EQ(found.b.triangle, expected.triangle_b);
  expect_apart(
      detail::Vec3d(found.a.position), detail::Vec3d(found.b.position), found.distance,
      std::max(largest_coordinate(a[found.a.triangle]), largest_coordinate(b[found.b.triangle])));
}

QueryStats ask_distance(Stage& stage, Distance& found) {
  return distance(stage.a.to, stage.b.to, stage.scratch, found);
}

std::vector<Contact> near_pairs(const Stage& stage) {
  return test::brute_clearance(stage.a.triangles(), stage.b.triangles(), stage.tolerance);
}

void swap_near_pairs(std::vector<Contact>& pairs) {
  for (Contact& pair : pairs) std::swap(pair.triangle_a, pair.triangle_b);
  std::sort(pairs.begin(), pairs.end());
}

using ClosestPoints = std::vector<ClosestPoint>;

/// The lowest of the triangles closest to a point.
void expect_closest(const Triangles& triangles, const Vec3& point, const ClosestPoint& found) {
  double least = HUGE_VAL;
  std::uint32_t triangle = 0;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const double squared =
        detail::closest_on_triangle(detail::Vec3d(point), triangles[i]).squared_distance;
    if (squared < least) least = squared, triangle = i;
  }
  ASSERT_EQ(found.distance, std::sqrt(least));
  ASSERT_EQ(found.point.triangle, triangle);
  expect_apart(detail::Vec3d(point), detail::Vec3d(found.point.position), found.distance,
               largest_coordinate(triangles[triangle]));
}

void expect_all_closest(const Stage& stage, const ClosestPoints& found) {
  ASSERT_EQ(found.size(), stage.points.size());
  const auto triangles = stage.a.triangles();
  for (std::size_t i = 0; i < found.size(); ++i)
    expect_closest(triangles, stage.points[i], found[i]);
}

QueryStats ask_each_point(Stage& stage, ClosestPoints& found) {
  found.resize(stage.points.size());
  QueryStats work;
  for (std::size_t i = 0; i < found.size(); ++i)
    work += closest_point(stage.a.to, stage.points[i], stage.scratch, found[i]);
  return work;
}

QueryStats ask_all_points(Stage& stage, ClosestPoints& found) {
  found.resize(stage.points.size());
  return closest_points(stage.a.to, stage.points, stage.scratch, found);
}

bool is_apart(const ClosestPoints& found) {
  return std::any_of(found.begin(), found.end(),
                     [](const ClosestPoint& point) { return point.distance > 0; });
}

void expect_right_from_solid(const Stage& stage, const SolidDistance& found) {
  const auto expected =
      test::brute_distance(stage.solid, stage.a.shape.triangles, positions_of(stage.a.to));
  EXPECT_EQ(found.distance, expected.distance);
  EXPECT_EQ(found.surface.triangle, expected.triangle);
}

void expect_right_from_field(const Stage& stage, const Distance& found) {
  Triangles all, existing;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t t = 0; t < stage.field.triangle_count(); ++t) {
    all.push_back(stage.field.triangle(t));
    if (!test::is_hole(all.back())) existing.push_back(all.back()), numbers.push_back(t);
  }
  const Triangles a = stage.a.triangles();
  test::BruteDistance expected = test::brute_distance(a, existing);
  expected.triangle_b = numbers[expected.triangle_b];
  expect_equal(found, expected, a, all);
}

}  // namespace

void add_distance_queries(Queries& queries) {
  add(queries, ValueRow<Distance>{
                   .name = "Distance",
                   .ask = ask_distance,
                   .expect_right =
                       [](const Stage& s, const Distance& found) {
                         const Triangles a = s.a.triangles(), b = s.b.triangles();
                         expect_equal(found, test::brute_distance(a, b), a, b);
                       },
                   .is_hit = [](const Distance& found) { return found.distance == 0; },
                   .traits = {.of_two_bodies = true, .varies_in_work = true},
                   .expect_swapped =
                       [](const Distance& found, const Distance& swapped) {
                         EXPECT_NEAR(swapped.distance, found.distance, 1e-12 * found.distance);
                       }});
  add(queries, ListRow<Contact>{
                   .name = "Clearance",
                   .ask =
                       [](Stage& s, std::vector<Contact>& pairs, std::uint32_t limit) {
                         return clearance(s.a.to, s.b.to, s.tolerance, s.scratch, pairs, {limit});
                       },
                   .brute_force = near_pairs,
                   .traits = {.is_limited = true, .of_two_bodies = true, .varies_in_work = true},
                   .swap = swap_near_pairs});
  add(queries,
      YesNoRow{.name = "IsWithin",
               .ask = [](Stage& s) { return is_within(s.a.to, s.b.to, s.tolerance, s.scratch); },
               .brute_force = [](const Stage& s) { return !near_pairs(s).empty(); },
               .traits = {.of_two_bodies = true}});
  for (const auto& [name, ask] :
       {std::pair("ClosestPoint", &ask_each_point), std::pair("ClosestPoints", &ask_all_points)})
    add(queries, ValueRow<ClosestPoints>{.name = name,
                                         .ask = ask,
                                         .expect_right = expect_all_closest,
                                         .is_hit = is_apart,
                                         .traits = {.always_hits = true}});
  add(queries,
      ValueRow<SolidDistance>{
          .name = "DistanceFromSolid",
          .ask = [](Stage& s,
                    SolidDistance& found) { return distance(s.a.to, s.solid, s.scratch, found); },
          .expect_right = expect_right_from_solid,
          .is_hit = [](const SolidDistance& found) { return found.distance == 0; }});
  add(queries,
      ValueRow<Distance>{
          .name = "DistanceFromField",
          .ask = [](Stage& s,
                    Distance& found) { return distance(s.a.to, s.field, s.scratch, found); },
          .expect_right = expect_right_from_field,
          .is_hit = [](const Distance& found) { return found.distance == 0; },
          .traits = {.varies_in_work = true}});
}

}  // namespace pelt::contract
