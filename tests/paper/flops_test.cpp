/// The operations that section 4.2 of Kavan & Zara 2005 counts: the counted refit reproduces the
/// total sum_i (18 p_i + 11 m_i + 8 p_i m_i - 2), and its spheres equal those of
/// paper/refit.

#include "paper/counted_refit.hpp"
#include "paper/on_demand.hpp"
#include "posed_mesh.hpp"

#include <gtest/gtest.h>

namespace pelt::paper {
namespace {

using test::Motion;
using test::Random;
using test::Weights;

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
