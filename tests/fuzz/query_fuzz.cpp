/// The fuzz target of the interface: bytes -> two bodies and queries, on any instruction set.
/// Compares every query with brute force over all posed triangles. Integer arithmetic decides
/// whether triangles intersect and on which side a point is; the library's functions for single
/// triangles give distances and ray hits.

#include "distance/brute_distance.hpp"
#include "fuzz/fuzzed_bodies.hpp"
#include "geometry/hulls_meet.hpp"
#include "ray/ray_oracle.hpp"
#include "solid/region_oracle.hpp"
#include "support/exact_winding.hpp"
#include "support/require.hpp"
#include "support/values.hpp"

#include <pelt/instruction_set.hpp>
#include <pelt/pelt.hpp>

#include <cmath>

namespace pelt::test {
namespace {

BigTriangle big_triangle(const std::array<Vec3, 3>& t) {
  return {to_big(t[0]), to_big(t[1]), to_big(t[2])};
}

std::vector<Contact> expected_contacts(const FuzzedBody& a, const FuzzedBody& b) {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < a.shape.triangles.size(); ++i)
    for (std::uint32_t j = 0; j < b.shape.triangles.size(); ++j) {
      const bool meet =
          hulls_meet<mpz_class>(big_triangle(a.corners(i)), big_triangle(b.corners(j)));
      require(detail::triangles_intersect(a.corners(i), b.corners(j)) == meet,
              "triangles_intersect is not exact");
      if (meet) contacts.push_back({i, j});
    }
  return contacts;
}

void check_contacts(FuzzedBody& a, FuzzedBody& b, Scratch& scratch) {
  const std::vector<Contact> expected = expected_contacts(a, b);
  std::vector<Contact> contacts;
  require(static_cast<bool>(intersects(a.pose, b.pose, scratch)) == !expected.empty(),
          "intersects");
  collide(a.pose, b.pose, scratch, contacts);
  require(contacts == expected, "collide");
  ContactGeometry geometry;
  describe_contacts(a.pose, a.surface, b.pose, b.surface, contacts, scratch, geometry);
  require(geometry.traces.size() == contacts.size(), "describe_contacts leaves contacts out");
}

std::uint32_t add(Crowd& crowd, const FuzzedBody& body) {
  const std::uint32_t instance = crowd.add(body.pose.model());
  require(static_cast<bool>(crowd.set_palette(instance, body.palette)), "a crowd's palette");
  require(static_cast<bool>(crowd.set_morph_weights(instance, body.morph_weights)),
          "a crowd's morph weights");
  return instance;
}

void check_crowd(FuzzBytes& bytes, const FuzzedBody& a, const FuzzedBody& b) {
  Crowd crowd;
  const std::uint32_t first = add(crowd, a), second = add(crowd, b);
  std::vector<CrowdContact> expected, contacts;
  for (const Contact& c : expected_contacts(a, b))
    expected.push_back({first, second, c.triangle_a, c.triangle_b});
  crowd.collide(contacts, {.threads = 1 + bytes.index(2)});
  require(contacts == expected, "the contacts of a crowd");
}

/// Twice the largest error of a measured distance (triangle_distance.hpp): if a distance was
/// measured too small, boxes beyond it are not searched.
double error_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double size = 0;
  for (const std::vector<Vec3>* points : {&a, &b})
    for (const Vec3& p : *points)
      for (const float c : {p.x, p.y, p.z}) size = std::max(size, 2 * std::abs(double{c}));
  return 2 * detail::kDistanceError * size;
}

/// Bitwise equality if the error is too small to matter.
bool agree(double found, double expected, double error) {
  return error < 1e-9 * expected ? found == expected : std::abs(found - expected) <= error;
}

void check_distances(FuzzBytes& bytes, FuzzedBody& a, FuzzedBody& b, Scratch& scratch) {
  const std::vector<TriangleCorners> of_a = posed_triangles(a.shape.triangles, a.pose);
  const std::vector<TriangleCorners> of_b = posed_triangles(b.shape.triangles, b.pose);
  const BruteDistance expected = brute_distance(of_a, of_b);
  const double error = error_between(a.posed, b.posed);
  Distance closest;
  distance(a.pose, b.pose, scratch, closest);
  require((closest.distance == 0) == (expected.distance == 0) || error >= expected.distance,
          "distance of what touches");
  require(agree(closest.distance, expected.distance, error), "distance");
  if (expected.distance == 0 || error < 1e-9 * expected.distance)
    require(closest.a.triangle == expected.triangle_a && closest.b.triangle == expected.triangle_b,
            "the pair that is closest");
  const double tolerance = double{bytes.size()};
  if (std::abs(tolerance - expected.distance) > error)
    require(static_cast<bool>(is_within(a.pose, b.pose, tolerance, scratch)) ==
                (expected.distance <= tolerance),
            "is_within");
}

void check_closest_point(const Vec3& point, FuzzedBody& body, Scratch& scratch) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < body.shape.triangles.size(); ++t)
    least = std::min(
        least, detail::closest_on_triangle(detail::Vec3d(point), body.corners(t)).squared_distance);
  ClosestPoint closest;
  closest_point(body.pose, point, scratch, closest);
  require(agree(closest.distance, std::sqrt(least), error_between(body.posed, {point})),
          "closest_point");
}

void check_ray(const Ray& ray, FuzzedBody& body, Scratch& scratch) {
  const RayOracle oracle(body.shape.triangles, body.pose);
  const std::vector<RayHit> expected = oracle.all(ray);
  std::vector<RayHit> hits;
  cast_all(body.pose, ray, scratch, hits);
  require(hits.size() == expected.size(), "cast_all");
  for (std::size_t i = 0; i < hits.size(); ++i)
    require(without_location(hits[i]) == expected[i], "a hit of cast_all");
  RayHit first;
  cast(body.pose, std::span(&ray, 1), std::span(&first, 1));
  require(without_location(first) == (expected.empty() ? RayHit() : expected[0]), "cast");
  bool any = false;
  cast_any(body.pose, std::span(&ray, 1), std::span(&any, 1));
  require(any == !expected.empty(), "cast_any");
}

Region make_region(FuzzBytes& bytes) {
  const std::uint32_t kind = bytes.index(4);
  const Vec3 p = bytes.point(), q = bytes.point();
  switch (kind) {
    case 0:
      return Box{{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                 {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
    case 1:
      return Sphere{p, bytes.size()};
    case 2:
      return Capsule{p, q, bytes.size()};
    default:
      return HalfSpace{q, bytes.coordinate()};
  }
}

void check_region(const Region& region, FuzzedBody& body, Scratch& scratch) {
  const TrianglesInRegion expected = brute_force(region, body.shape.triangles, body.posed);
  TrianglesInRegion found;
  find_triangles(body.pose, region, scratch, found);
  require(found.intersecting == expected.intersecting && found.inside == expected.inside,
          "find_triangles");
  require(
      static_cast<bool>(intersects(body.pose, region, scratch)) == !expected.intersecting.empty(),
      "intersects of a region");
}

PointSide side(FuzzedBody& body, const Vec3& point, Scratch& scratch) {
  return point_side(body.pose, body.surface, point, scratch);
}

/// The vertices that belong to a triangle.
std::vector<Vec3> used_vertices(const FuzzedBody& body) {
  std::vector<Vec3> used;
  for (std::size_t t = 0; t < body.shape.triangles.size(); ++t)
    for (const Vec3& corner : body.corners(t)) used.push_back(corner);
  return used;
}

void check_inside(FuzzBytes& bytes, FuzzedBody& a, FuzzedBody& b, Scratch& scratch) {
  if (!b.surface.is_closed()) return;
  ExactWinding winding(b.posed, b.shape.triangles);
  double depth = 0;
  for (const Vec3& point : used_vertices(a)) {
    const PointSide expected = winding.side_of(point);
    require(side(b, point, scratch) == expected, "side_of a vertex");
    if (expected != PointSide::inside) continue;
    ClosestPoint closest;
    closest_point(b.pose, point, scratch, closest);
    depth = std::max(depth, closest.distance);
  }
  const double error = error_between(a.posed, b.posed);
  const Vec3 point = bytes.point();
  require(side(b, point, scratch) == winding.side_of(point), "side_of");
  Penetration deepest;
  deepest_vertex(a.pose, a.surface, b.pose, b.surface, scratch, deepest);
  require(agree(deepest.depth, depth, error), "deepest_vertex");
}

void check_bounds_of(FuzzedBody& body) {
  require(check_bounds(body.pose).empty(), "bounds that do not enclose");
}

void ask_everything(FuzzBytes& bytes) {
  const auto sets = available_instruction_sets();
  set_active_instruction_set(sets[bytes.index(static_cast<std::uint32_t>(sets.size()))]);
  std::optional<FuzzedBody> a = make_body(bytes), b = make_body(bytes);
  if (!a || !b) return;
  Scratch scratch;
  check_contacts(*a, *b, scratch);
  check_distances(bytes, *a, *b, scratch);
  check_closest_point(bytes.point(), *a, scratch);
  const Vec3 origin = bytes.point(), direction = bytes.point();
  check_ray({origin, direction}, *b, scratch);
  check_region(make_region(bytes), *a, scratch);
  check_inside(bytes, *a, *b, scratch);
  check_inside(bytes, *b, *a, scratch);
  check_bounds_of(*a);
  if (bytes.index(4) == 1) check_crowd(bytes, *a, *b);
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pelt::test::FuzzBytes bytes(std::span(data, size));
  pelt::test::ask_everything(bytes);
  return 0;
}
