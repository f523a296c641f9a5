#include "fuzz/goal.hpp"
#include "fuzz/pair_oracle.hpp"
#include "fuzz/questions.hpp"
#include "support/exact_winding.hpp"
#include "support/require.hpp"
#include "support/values.hpp"

#include <pelt/inside.hpp>

#include <algorithm>
#include <vector>

namespace pelt::test {
namespace {

Goal point_inside("side_of: inside"), point_on("side_of: on"), point_outside("side_of: outside"),
    deepest_found("deepest_vertex: found"), deepest_none("deepest_vertex: none"),
    contained("containment: a body contains the other"), not_contained("containment: none");

/// The side by integers if both bodies are small, or else by the library.
PointSide expected_side(Question& q, FuzzedBody& body, const Vec3& point) {
  if (q.a.is_small() && q.b.is_small())
    return ExactWinding(body.posed, body.shape.triangles).side_of(point);
  return point_side(body.pose, point, q.scratch);
}

/// Ascending, without repetition.
std::vector<std::uint32_t> used_vertices(const FuzzedBody& body) {
  std::vector<std::uint32_t> used;
  for (const Triangle& triangle : body.shape.triangles)
    used.insert(used.end(), triangle.begin(), triangle.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

double distance_from(const FuzzedBody& body, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < body.triangle_count(); ++t)
    least = std::min(
        least, detail::closest_on_triangle(detail::Vec3d(point), body.corners(t)).squared_distance);
  return std::sqrt(least);
}

/// Whether all of `inner`, which does not touch `outer`, is inside.
bool is_inside(Question& q, const FuzzedBody& inner, FuzzedBody& outer) {
  if (!outer.pose.model().surface().is_closed()) return false;
  const auto used = used_vertices(inner);
  return std::all_of(used.begin(), used.end(), [&](std::uint32_t vertex) {
    return expected_side(q, outer, inner.posed[vertex]) == PointSide::inside;
  });
}

Containment expected_containment(Question& q) {
  if (!intersecting_pairs(q.a.all_corners(), q.b.all_corners()).empty()) return Containment::none;
  if (is_inside(q, q.a, q.b)) return Containment::a_in_b;
  return is_inside(q, q.b, q.a) ? Containment::b_in_a : Containment::none;
}

}  // namespace

void ask_side(Question& q) {
  const Vec3 point = point_near(q.bytes, q.a);
  if (!q.b.pose.model().surface().is_closed()) return;
  const PointSide side = point_side(q.b.pose, point, q.scratch);
  require(side == expected_side(q, q.b, point), "side_of");
  (side == PointSide::inside ? point_inside
   : side == PointSide::on   ? point_on
                             : point_outside)
      .reach();
}

void ask_deepest_vertex(Question& q) {
  if (!q.b.pose.model().surface().is_closed()) return;
  Penetration expected;
  for (const std::uint32_t vertex : used_vertices(q.a)) {
    if (expected_side(q, q.b, q.a.posed[vertex]) != PointSide::inside) continue;
    const double depth = distance_from(q.b, q.a.posed[vertex]);
    if (!expected || depth > expected.depth) expected = {vertex, q.a.posed[vertex], {}, depth};
  }
  Penetration found;
  deepest_vertex(q.a.pose, q.b.pose, q.scratch, found);
  require(found.vertex == expected.vertex && found.position == expected.position, "deepest_vertex");
  require(found.depth == expected.depth, "the depth of deepest_vertex");
  (found ? deepest_found : deepest_none).reach();
}

void ask_containment(Question& q) {
  Containment found = Containment::none;
  containment(q.a.pose, q.b.pose, q.scratch, found);
  require(found == expected_containment(q), "containment");
  (found == Containment::none ? not_contained : contained).reach();
}

}  // namespace pelt::test
