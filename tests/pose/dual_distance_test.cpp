/// Distances, sides and bounds of poses with dual quaternion skinning against brute force.

#include "base/vec3.hpp"
#include "distance/brute_distance.hpp"
#include "pose/dual_bodies.hpp"
#include "support/instruction_sets.hpp"

#include <pelt/pelt.hpp>

namespace pelt::test {
namespace {

using detail::Vec3d;

std::vector<Vec3> positions_of(const Pose& pose) {
  std::vector<Vec3> posed(pose.model().vertex_count());
  posed_vertices(pose, posed);
  return posed;
}

TEST(DualDistance, IsTheLeastOfAllPairs) {
  Random random(160);
  int apart = 0, touching = 0;
  std::size_t near = 0;
  on_all_kinds(random, 3, 60, 0.8, [&](DualBody& a, DualBody& b) {
    const auto s = posed_triangles(a.shape.triangles, a.to);
    const auto t = posed_triangles(b.shape.triangles, b.to);
    const BruteDistance expected = brute_distance(s, t);
    Scratch scratch;
    Distance found;
    distance(a.to, b.to, scratch, found);
    ASSERT_EQ(found.distance, expected.distance);
    const double tolerance = expected.distance * 1.05 + 0.01;
    std::vector<Contact> pairs;
    clearance(a.to, b.to, tolerance, scratch, pairs);
    const std::vector<Contact> all = brute_clearance(s, t, tolerance);
    ASSERT_EQ(pairs, all);
    EXPECT_TRUE(is_within(a.to, b.to, expected.distance, scratch));
    near += all.size();
    ++(expected.distance > 0 ? apart : touching);
  });
  std::printf("%d apart, %d touching, %zu near pairs\n", apart, touching, near);
  EXPECT_GT(apart, 30);
  EXPECT_GT(touching, 30);
  EXPECT_GT(near, 2000u);
}

double point_distance(const std::vector<TriangleCorners>& triangles, const Vec3& point) {
  double least = HUGE_VAL;
  for (const TriangleCorners& t : triangles)
    least = std::min(least, closest_points(t, {point, point, point}).squared_distance);
  return std::sqrt(least);
}

/// A point at most `distance` from a random corner on each axis.
Vec3 point_near(Random& random, const std::vector<TriangleCorners>& triangles, double distance) {
  const Vec3 corner = triangles[random.index(static_cast<std::uint32_t>(triangles.size()))][0];
  const Vec3 off = random.point(distance);
  return {corner.x + off.x, corner.y + off.y, corner.z + off.z};
}

TEST(DualDistance, OfPointsIsTheLeastOfAllTriangles) {
  Random random(161);
  std::size_t found = 0;
  on_all_kinds(random, 2, 60, 0.2, [&](DualBody& body, DualBody&) {
    const auto triangles = posed_triangles(body.shape.triangles, body.to);
    Scratch scratch;
    for (int i = 0; i < 20; ++i) {
      const Vec3 point = point_near(random, triangles, 0.3);
      ClosestPoint closest;
      closest_point(body.to, point, scratch, closest);
      const double expected = point_distance(triangles, point);
      ASSERT_NEAR(closest.distance, expected, 1e-6 * expected);
      found += expected > 0;
    }
  });
  EXPECT_GT(found, 1500u);
}

/// The winding number of the posed surface around a point, by the solid angles of its triangles
/// (Van Oosterom & Strackee 1983).
double winding_number(const std::vector<TriangleCorners>& triangles, const Vec3& point) {
  double angle = 0;
  for (const TriangleCorners& t : triangles) {
    const Vec3d a = Vec3d(t[0]) - Vec3d(point), b = Vec3d(t[1]) - Vec3d(point),
                c = Vec3d(t[2]) - Vec3d(point);
    const double x = std::sqrt(squared_length(a)), y = std::sqrt(squared_length(b)),
                 z = std::sqrt(squared_length(c));
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            x * y * z + dot(a, b) * z + dot(b, c) * x + dot(a, c) * y);
  }
  return angle / (4 * 3.14159265358979323846);
}

TEST(DualDistance, SidesAreWhereTheSurfaceWinds) {
  Random random(162);
  int inside = 0, outside = 0;
  on_all_kinds(random, 2, 60, 0.2, [&](DualBody& body, DualBody&) {
    if (body.kind.is_soup || body.kind.turns == Turns::far_away) return;  // open, or too coarse
    ASSERT_TRUE(body.to.model().surface().is_closed());
    const auto triangles = posed_triangles(body.shape.triangles, body.to);
    Scratch scratch;
    for (int i = 0; i < 40; ++i) {
      const Vec3 point = point_near(random, triangles, 0.1);
      const double winding = winding_number(triangles, point);
      if (std::abs(winding - std::round(winding)) > 1e-3) continue;  // too near for this method
      PointSide side = PointSide::outside;
      side_of(body.to, point, scratch, side);
      ASSERT_EQ(side == PointSide::inside, std::round(winding) != 0) << winding;
      ++(side == PointSide::inside ? inside : outside);
    }
  });
  std::printf("%d inside, %d outside\n", inside, outside);
  EXPECT_GT(inside, 150);
  EXPECT_GT(outside, 300);
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3d sum;
  for (const Vec3& p : points) sum = sum + Vec3d(p);
  return to_float(1.0 / static_cast<double>(points.size()) * sum);
}

/// A copy of the body, shrunk to a tenth towards the middle of one of its rings, is inside it.
TEST(DualDistance, SmallBodiesAreContained) {
  Random random(163);
  int contained = 0, apart = 0;
  on_all_kinds(random, 2, 60, 0.2, [&](DualBody& body, DualBody& other) {
    if (body.kind.is_soup || body.kind.turns == Turns::far_away) return;
    const auto triangles = posed_triangles(body.shape.triangles, body.to);
    const std::vector<Vec3> posed = positions_of(body.to);
    const std::size_t ring = 6 * random.index(static_cast<std::uint32_t>(posed.size() / 6));
    const Vec3 middle = mean_of({posed.begin() + static_cast<std::ptrdiff_t>(ring),
                                 posed.begin() + static_cast<std::ptrdiff_t>(ring) + 6});
    std::vector<Vec3> small = positions_of(other.to);
    const Vec3 centre = mean_of(small);
    for (Vec3& p : small) p = to_float(0.01 * (Vec3d(p) - Vec3d(centre)) + Vec3d(middle));
    Pose within(other.to.model());
    ASSERT_TRUE(within.set_vertices(small));
    Scratch scratch;
    if (intersects(body.to, within, scratch)) return;
    Containment found = {};
    containment(body.to, within, scratch, found);
    const bool is_inside = std::round(winding_number(triangles, small[0])) != 0;
    ASSERT_EQ(found, is_inside ? Containment::b_in_a : Containment::none);
    ++(is_inside ? contained : apart);
  });
  std::printf("%d contained, %d apart\n", contained, apart);
  EXPECT_GT(contained, 8);
  EXPECT_GT(apart, 2);
}

bool encloses(const Box& outer, const Box& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && outer.low.z <= inner.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y &&
         inner.high.z <= outer.high.z;
}

Box box_of(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  Box box = {{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t)
      for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        box.low.*axis = std::min(box.low.*axis, points[v].*axis);
        box.high.*axis = std::max(box.high.*axis, points[v].*axis);
      }
  return box;
}

double farthest_from(const Vec3& centre, const std::vector<Vec3>& points,
                     const std::vector<Triangle>& triangles) {
  double farthest = 0;
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t)
      farthest = std::max(farthest, squared_length(Vec3d(points[v]) - Vec3d(centre)));
  return std::sqrt(farthest);
}

TEST(DualDistance, BoundsEncloseAllVertices) {
  Random random(164);
  int bodies = 0;
  on_all_kinds(random, 12, 60, 0.2, [&](DualBody& body, DualBody&) {
    const std::vector<Vec3> posed = positions_of(body.to);
    const Box expected = box_of(posed, body.shape.triangles);
    Bounds loose, exact;
    exact_bounds(body.to, exact);
    ASSERT_TRUE(encloses(exact.box, expected) && encloses(expected, exact.box));
    on_each_instruction_set([&](InstructionSet) {
      body.to.reserve();  // closes all nodes
      for (const std::uint32_t levels : {0u, 1u, 2u}) {
        bounds(body.to, loose, levels);
        ASSERT_TRUE(encloses(loose.box, expected));
        ASSERT_LE(farthest_from(loose.sphere.centre, posed, body.shape.triangles),
                  double{loose.sphere.radius});
      }
      ASSERT_EQ(check_bounds(body.to), "");
    });
    ++bodies;
  });
  EXPECT_EQ(bodies, 480);
}

}  // namespace
}  // namespace pelt::test
