/// Section 3 of Kavan & Zara 2005: linear blend skinning, and why bounding volumes must not be
/// deformed like the skin.

#include "paper/counted_refit.hpp"
#include "paper/on_demand.hpp"
#include "paper/posed_mesh.hpp"

#include <gtest/gtest.h>

namespace pelt::paper {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

/// v' = C_j v in float32, the operations in the order of the definition of a posed vertex.
Vec3 transformed(const Matrix4& c, const Vec3& v) {
  const auto coordinate = [&](std::size_t row) {
    return (c.m[row] * v.x + c.m[8 + row] * v.z) + (c.m[4 + row] * v.y + c.m[12 + row]);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

TEST(Skinning, OneJointIsASpecialCaseBitForBit) {
  Random random(1);
  int vertices = 0;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away}) {
    const SkinnedMesh mesh = test::checked_mesh(make_soup(random, 100, 5, 3, Weights::one_joint));
    const Palette palette = test::checked_palette(mesh, make_palette(random, 5, motion, 1));
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v, ++vertices) {
      ASSERT_EQ(mesh.influences_of(v).size(), 1u);
      const Matrix4& joint = palette[mesh.influences_of(v)[0].joint];
      ASSERT_EQ(detail::posed_vertex(mesh, palette, v), transformed(joint, mesh.rest_positions[v]));
    }
  }
  EXPECT_GT(vertices, 400);
}

/// Two vertices at opposite ends of the unit ball around the origin. One follows joint 0, the other
/// joint 1.
Shape make_split_triangle() {
  Shape shape;
  shape.rest_positions = {{-1, 0, 0}, {1, 0, 0}};
  shape.triangles = {{0, 1, 1}};
  shape.influences_per_vertex = 1;
  shape.joints = {0, 1};
  shape.weights = {1, 1};
  shape.joint_count = 2;
  return shape;
}

TEST(Skinning, ABallDeformedLikeTheSkinLosesItsVertices) {
  const SkinnedMesh mesh = test::checked_mesh(make_split_triangle());
  const SphereModel model = build_sphere_model(mesh);
  const Sphere rest = model.tree.nodes[0].rest;
  ASSERT_EQ(rest.centre, Vec3());
  ASSERT_NEAR(rest.radius, 1, 1e-6);

  // Joint 1 only rotates, half a turn about an axis at x = 3: the vertices are then six apart.
  std::vector<Matrix4> joints(2);
  joints[1] = test::rotation_about({0, 1, 0}, 3.14159265358979, {3, 0, 0}, {});
  const Palette palette = test::checked_palette(mesh, joints);
  const Vec3 a = detail::posed_vertex(mesh, palette, 0);
  const Vec3 b = detail::posed_vertex(mesh, palette, 1);

  // A rotation preserves the radius, so wherever the ball moves, its points are at most two apart.
  const double apart = std::sqrt(squared_length(detail::Vec3d(a) - detail::Vec3d(b)));
  EXPECT_GT(apart, 2 * 2.9 * static_cast<double>(rest.radius));
  const Float4 refitted = Refit(model, 2).sphere(0, palette);
  EXPECT_LE(test::relative_reach(refitted, a), 1);
  EXPECT_LE(test::relative_reach(refitted, b), 1);
}

// The operations that section 4.2 of Kavan & Zara 2005 counts: the counted refit reproduces the
// total sum_i (18 p_i + 11 m_i + 8 p_i m_i - 2), and its spheres equal those of
// paper/refit.

/// The total as in the paper, not step by step.
int stated_total(std::span<const JointSet> sets) {
  int sum = 0;
  for (const JointSet& set : sets) {
    const int p = set.joint_count, m = set.corner_count;
    sum += 18 * p + 11 * m + 8 * p * m - 2;
  }
  return sum;
}

/// Shapes with one, a few and many joint sets in a node, of 1 to 8 joints.
std::vector<test::Shape> make_shapes(Random& random) {
  std::vector<test::Shape> shapes = {test::make_limb(16, 8, 5), test::make_limb(24, 6, 9)};
  for (const std::uint32_t influences : {1, 2, 4, 8})
    shapes.push_back(make_soup(random, 60, 9, influences, Weights::random));
  return shapes;
}

TEST(Flops, CountedOperationsAreTheFormula) {
  Random random(1);
  int nodes_of_one_set = 0, nodes_of_several_sets = 0;
  for (const test::Shape& shape : make_shapes(random)) {
    const SkinnedMesh mesh = test::checked_mesh(shape);
    const SphereModel model = build_sphere_model(mesh);
    const Palette palette =
        test::checked_palette(mesh, make_palette(random, mesh.joint_count, Motion::rigid, 1));
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
      const std::span<const JointSet> sets = model.bounds.sets_of(n);
      const RefitFlops flops = counted_refit(model, n, palette).flops;
      const RefitFlops stated = stated_flops(sets);
      const auto set_count = static_cast<int>(sets.size());
      const int joined = 2 * (set_count - 1);
      ASSERT_EQ(flops.transforms, stated.transforms);
      ASSERT_EQ(flops.blends, stated.blends);
      ASSERT_EQ(flops.enclosing, stated.enclosing + joined);
      ASSERT_EQ(flops.total(), stated_total(sets) + joined);
      ++(set_count == 1 ? nodes_of_one_set : nodes_of_several_sets);
    }
  }
  EXPECT_GT(nodes_of_one_set, 100);
  EXPECT_GT(nodes_of_several_sets, 100);
}

TEST(Flops, TheCountedRefitGivesTheSphereOfThePapersRefit) {
  Random random(2);
  for (const test::Shape& shape : make_shapes(random)) {
    const SkinnedMesh mesh = test::checked_mesh(shape);
    const SphereModel model = build_sphere_model(mesh);
    const Palette palette =
        test::checked_palette(mesh, make_palette(random, mesh.joint_count, Motion::rigid, 1));
    Refit refit(model, mesh.joint_count);
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
      const CountedRefit expected = counted_refit(model, n, palette);
      const Float4 sphere = refit.sphere(n, palette);
      const double room = test::rounding_room(model, palette, expected.radius);
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(sphere[static_cast<int>(axis)], expected.centre[axis], room);
      ASSERT_GE(sphere[3], expected.radius);
      ASSERT_LE(sphere[3], expected.radius + room);
    }
  }
}

}  // namespace
}  // namespace pelt::paper
