/// Points and bodies inside of closed bodies, and volumes.

#include "base/vec3.hpp"
#include "distance/brute_distance.hpp"
#include "support/contract/query.hpp"
#include "volume/self_volume_reference.hpp"

#include <array>
#include <cmath>

namespace pelt::contract {
namespace {

using detail::Vec3d;

/// The winding number of the posed surface around a point, by the solid angles of its triangles
/// (Van Oosterom & Strackee 1983), without rays and predicates.
double winding_number(const Triangles& triangles, const Vec3& point) {
  double angle = 0;
  for (const test::TriangleCorners& t : triangles) {
    const Vec3d a = Vec3d(t[0]) - Vec3d(point), b = Vec3d(t[1]) - Vec3d(point),
                c = Vec3d(t[2]) - Vec3d(point);
    const double x = std::sqrt(squared_length(a)), y = std::sqrt(squared_length(b)),
                 z = std::sqrt(squared_length(c));
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            x * y * z + dot(a, b) * z + dot(b, c) * x + dot(a, c) * y);
  }
  return angle / (4 * 3.14159265358979323846);
}

bool are_closed(const Stage& stage) {
  return stage.a.to.model().surface().is_closed() && stage.b.to.model().surface().is_closed();
}

/// Points near the surface, of which few are inside otherwise.
void arrange_points(Stage& stage) {
  const std::vector<Vec3> positions = positions_of(stage.a.to);
  for (std::size_t i = 1; i < stage.points.size(); i += 2) {
    const Vec3 &p = positions[i % positions.size()], &q = positions[(i + 3) % positions.size()];
    stage.points[i] = {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
  }
}

struct Side {
  PointSide side = PointSide::outside;
  std::int32_t winding = 0;
};
void put(Numbers& numbers, const Side& side) {
  contract::put(numbers, side.side), contract::put(numbers, side.winding);
}

struct Sides {
  std::array<Side, 12> of_points;
};
void put(Numbers& numbers, const Sides& sides) {
  for (const Side& side : sides.of_points) put(numbers, side);
}

QueryStats find_sides(Stage& stage, Sides& found) {
  QueryStats work;
  for (std::size_t i = 0; i < found.of_points.size(); ++i) {
    auto& [side, winding] = found.of_points[i];
    work += side_of(stage.a.to, stage.points[i], stage.scratch, side);
    work += pelt::winding_number(stage.a.to, stage.points[i], stage.scratch, winding);
  }
  return work;
}

void expect_sides(const Stage& stage, const Sides& found) {
  const auto triangles = stage.a.triangles();
  for (std::size_t i = 0; i < found.of_points.size(); ++i) {
    const auto& [side, winding] = found.of_points[i];
    const double expected = winding_number(triangles, stage.points[i]);
    // Nearer to the surface, only exact methods decide: see tests/inside.
    if (side == PointSide::on || std::abs(expected - std::round(expected)) > 1e-3) continue;
    EXPECT_EQ(winding, std::round(expected));
    EXPECT_EQ(side, winding != 0 ? PointSide::inside : PointSide::outside);
  }
}

bool has_inside(const Sides& found) {
  return std::any_of(found.of_points.begin(), found.of_points.end(),
                     [](const Side& side) { return side.side == PointSide::inside; });
}

QueryStats find_deepest(Stage& stage, Penetration& found) {
  found = {};
  return deepest_vertex(stage.a.to, stage.b.to, stage.scratch, found);
}

/// Asks for each vertex separately, where vertices are given.
void expect_deepest(const Stage& stage, const Penetration& found) {
  Body b = stage.b.given();
  Scratch scratch;
  Penetration deepest;
  const std::vector<Vec3> positions = positions_of(stage.a.to);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    PointSide side = PointSide::outside;
    side_of(b.to, positions[v], scratch, side);
    if (side != PointSide::inside) continue;
    ClosestPoint closest;
    closest_point(b.to, positions[v], scratch, closest);
    if (closest.distance > deepest.depth)
      deepest = {v, positions[v], closest.point, closest.distance};
  }
  EXPECT_EQ(numbers_of(found), numbers_of(deepest));
}

/// Shrinks `b` to a hundredth towards the middle of a ring of `a`, or to a point around it.
void shrink_body(Stage& stage) {
  const std::vector<Vec3> ring = positions_of(stage.a.to);
  Vec3d middle;
  for (std::size_t i = 0; i < 6; ++i)
    middle = middle + Vec3d(ring[(ring.size() / 12 * 6 + i) % ring.size()]);
  middle = 1.0 / 6 * middle;
  if (stage.rays[0].origin.x > stage.rays[1].origin.x) middle = Vec3d(stage.points[1]);
  stage.b = stage.b.given();
  for (PoseInput* input : {&stage.b.from_input, &stage.b.to_input}) {
    const Vec3d first(input->vertices[0]);
    for (Vec3& p : input->vertices) p = to_float(0.01 * (Vec3d(p) - first) + middle);
  }
  stage.b.renew();
}

QueryStats find_contained(Stage& stage, Containment& found) {
  return containment(stage.a.to, stage.b.to, stage.scratch, found);
}

void expect_contained(const Stage& stage, Containment found) {
  const auto a = stage.a.triangles(), b = stage.b.triangles();
  const double winding = winding_number(a, b[0][0]);
  if (test::brute_distance(a, b).distance == 0) {
    EXPECT_EQ(found, Containment::none);
  } else if (std::abs(winding - std::round(winding)) < 1e-3) {
    EXPECT_EQ(found, std::round(winding) != 0 ? Containment::b_in_a : Containment::none);
  }
}

/// The sum of tetrahedra between the origin of coordinates and the triangles.
void expect_volume(const Stage& stage, const Volume& found) {
  const auto triangles = stage.a.triangles();
  const Vec3d origin(triangles[0][0]);
  double sum = 0;
  for (const test::TriangleCorners& t : triangles)
    sum += dot(Vec3d(t[0]) - origin, cross(Vec3d(t[1]) - origin, Vec3d(t[2]) - origin)) / 6;
  const double size = 8.0 * double{stage.size} * double{stage.size} * double{stage.size};
  EXPECT_NEAR(found.value, sum, found.error + 1e-9 * size);
}

void expect_volume_with_a_copy(const Stage& stage, const Volume& found) {
  Body a = stage.a.given();
  test::expect_equal_within_errors(found, test::volume_with_a_copy(a.to));
}

bool is_not_zero(const Volume& volume) { return std::abs(volume.value) > volume.error; }

}  // namespace

void add_inside_queries(Queries& queries) {
  add(queries, ValueRow<Sides>{.name = "SideOf",
                               .ask = find_sides,
                               .expect_right = expect_sides,
                               .is_hit = has_inside,
                               .traits = {.always_hits = true},
                               .preparation = {.applies = are_closed, .arrange = arrange_points}});
  add(queries, ValueRow<Penetration>{.name = "DeepestVertex",
                                     .ask = find_deepest,
                                     .expect_right = expect_deepest,
                                     .is_hit = [](const Penetration& found) { return bool(found); },
                                     .preparation = {.applies = are_closed}});
  add(queries, ValueRow<Containment>{
                   .name = "Containment",
                   .ask = find_contained,
                   .expect_right = expect_contained,
                   .is_hit = [](Containment found) { return found != Containment::none; },
                   .traits = {.of_two_bodies = true},
                   .expect_swapped =
                       [](Containment found, Containment swapped) {
                         EXPECT_EQ(swapped == Containment::a_in_b, found == Containment::b_in_a);
                         EXPECT_NE(swapped, Containment::b_in_a);
                       },
                   .preparation = {.applies = are_closed, .arrange = shrink_body}});
  add(queries,
      ValueRow<Volume>{.name = "Volume",
                       .ask = [](Stage& s, Volume& found) { return volume(s.a.to, found); },
                       .expect_right = expect_volume,
                       .is_hit = is_not_zero,
                       .traits = {.always_hits = true},
                       .preparation = {.applies = are_closed}});
  add(queries, ValueRow<Volume>{.name = "SelfIntersectionVolume",
                                .ask =
                                    [](Stage& s, Volume& found) {
                                      return self_intersection_volume(s.a.to, s.scratch, found);
                                    },
                                .expect_right = expect_volume_with_a_copy,
                                .is_hit = is_not_zero,
                                .traits = {.reserves_when_asked = true},
                                .preparation = {.applies = are_closed}});
  // Brute force in exact numbers is in tests/volume.
  add(queries,
      ValueRow<Volume>{
          .name = "IntersectionVolume",
          .ask =
              [](Stage& s, Volume& found) {
                return intersection_volume(s.a.to, s.b.to, s.scratch, found);
              },
          .expect_right = [](const Stage&, const Volume& found) { EXPECT_GE(found.error, 0); },
          .is_hit = is_not_zero,
          .traits = {.of_two_bodies = true},
          .expect_swapped = test::expect_equal_within_errors,
          .preparation = {.applies = are_closed}});
}

}  // namespace pelt::contract
