#include <pelt/inside.hpp>

#include "base/vec3.hpp"
#include "pose/pose.hpp"
#include "support/closed_body.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt::test {
namespace {

TEST(SideOf, FindsPointsOnTheSurface) {
  Body body(make_cube(1, {0, 0, 0}));
  Scratch scratch;
  const auto side = [&](const Vec3& p) { return test::point_side(body.pose, p, scratch); };
  for (const Vec3& on : {Vec3{1, 1, 1}, Vec3{1, 0, 0}, Vec3{1, 0.5f, 0.25f}, Vec3{0.3f, -1, 1}})
    EXPECT_EQ(side(on), PointSide::on);
  const float less = std::nextafter(1.0f, 0.0f), more = std::nextafter(1.0f, 2.0f);
  EXPECT_EQ(side({less, less, less}), PointSide::inside);
  EXPECT_EQ(side({more, 0.5f, 0.25f}), PointSide::outside);
  EXPECT_EQ(side({0, 0, 0}), PointSide::inside);
}

TEST(SideOf, IsExactForMirroredBodies) {
  Body body(make_cube(1, {0, 0, 0}));
  Matrix4 mirror;
  mirror.m[0] = -1;
  body.set({mirror});
  Scratch scratch;
  EXPECT_EQ(test::point_side(body.pose, {0.5f, 0.25f, 0}, scratch), PointSide::inside);
  EXPECT_EQ(test::point_side(body.pose, {1.5f, 0.25f, 0}, scratch), PointSide::outside);
}

double depth_of(const Shape& shape_a, const Shape& shape_b) {
  Body a(shape_a), b(shape_b);
  Scratch scratch;
  Penetration deepest;
  deepest_vertex(a.pose, b.pose, scratch, deepest);
  return deepest.depth;
}

TEST(DeepestVertex, StaysAsDeepWhenTrianglesAreCut) {
  const Shape small = make_cube(0.5f, {0.8f, 0.1f, 0.05f}), large = make_cube(1, {0, 0, 0});
  // The middle of the small cube's side x = 0.3 is closest to the large cube's side x = 1.
  EXPECT_NEAR(depth_of(small, large), 0.7, 1e-6);
  EXPECT_NEAR(depth_of(cut(small), large), 0.7, 1e-6);
  EXPECT_NEAR(depth_of(cut(cut(small)), cut(large)), 0.7, 1e-6);
}

TEST(DeepestVertex, IsNoneOfBodiesApartOrAround) {
  const Shape small = make_cube(0.5f, {0, 0, 0}), large = make_cube(1, {0, 0, 0});
  EXPECT_EQ(depth_of(small, make_cube(1, {5, 0, 0})), 0);
  EXPECT_EQ(depth_of(large, small), 0);
  EXPECT_NEAR(depth_of(small, large), 0.5, 1e-12);
}

/// The number of vertices in all open nodes.
std::uint64_t opened_vertices(Pose& pose) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  std::uint64_t count = 0;
  for (std::uint32_t n = 0; posed.opened && n < posed.tree.nodes.size(); ++n)
    if (posed.opened[n] != nullptr) count += posed.tree.nodes[n].vertex_count;
  return count;
}

/// The query opened each open vertex and counted it once.
TEST(DeepestVertex, CountsAllWorkOnBothBodies) {
  Random random(14);
  Body a(make_limb(24, 13, 4)), b(make_limb(24, 11, 4));
  a.set(bend_limb(random, 4, 0.2, {0, 0, 0}));
  b.set(bend_limb(random, 4, 0.2, {0.05f, 0.02f, 0.03f}));
  Scratch scratch;
  Penetration deepest;
  const QueryStats work = deepest_vertex(a.pose, b.pose, scratch, deepest);
  EXPECT_TRUE(deepest);
  EXPECT_GT(opened_vertices(a.pose), 0u);
  EXPECT_GT(opened_vertices(b.pose), 0u);
  EXPECT_EQ(work.posed_vertices, opened_vertices(a.pose) + opened_vertices(b.pose));
  EXPECT_GT(work.refits, 0u);
  EXPECT_GT(work.triangle_pairs, 0u);
}

TEST(Containment, CountsAllWorkOnBothBodies) {
  Body small(make_cube(0.5f, {0, 0, 0})), large(make_cube(1, {0.25f, 0, 0}));
  Scratch scratch;
  Containment which = Containment::none;
  const QueryStats work = containment(small.pose, large.pose, scratch, which);
  EXPECT_EQ(which, Containment::a_in_b);
  EXPECT_GT(opened_vertices(small.pose), 0u);
  EXPECT_EQ(work.posed_vertices, opened_vertices(small.pose) + opened_vertices(large.pose));
  EXPECT_GT(work.node_pairs, 2u);
}

Containment containment_of(const Shape& shape_a, const Shape& shape_b) {
  Body a(shape_a), b(shape_b);
  Scratch scratch;
  Containment which = Containment::none;
  containment(a.pose, b.pose, scratch, which);
  return which;
}

TEST(Containment, FindsWhichBodyContainsTheOther) {
  const Shape small = make_cube(0.5f, {0, 0, 0}), large = make_cube(1, {0.25f, 0, 0});
  EXPECT_EQ(containment_of(small, large), Containment::a_in_b);
  EXPECT_EQ(containment_of(large, small), Containment::b_in_a);
  EXPECT_EQ(containment_of(small, make_cube(1, {5, 0, 0})), Containment::none);
  // A side of one cube is in the plane of a side of the other.
  EXPECT_EQ(containment_of(make_cube(0.5f, {0.75f, 0, 0}), large), Containment::none);
}

TEST(Containment, IsOfAllPartsThatHangTogether) {
  const Shape large = make_cube(1, {0, 0, 0}), part = make_cube(0.2f, {0.5f, 0, 0});
  EXPECT_EQ(containment_of(together(part, make_cube(0.2f, {-0.5f, 0, 0})), large),
            Containment::a_in_b);
  EXPECT_EQ(containment_of(together(part, make_cube(0.2f, {-5, 0, 0})), large), Containment::none);
}

TEST(Containment, IsNoneForSurfacesThatAreNotClosed) {
  Shape open = make_cube(1, {0, 0, 0});
  open.triangles.pop_back();
  EXPECT_EQ(containment_of(make_cube(0.5f, {0, 0, 0}), open), Containment::none);
}

}  // namespace
}  // namespace pelt::test
