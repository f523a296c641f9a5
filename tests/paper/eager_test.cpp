#include "paper/eager.hpp"

#include "paper/min_sphere.hpp"
#include "paper/on_demand.hpp"
#include "posed_mesh.hpp"

#include <gtest/gtest.h>

namespace pelt::paper {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

constexpr Motion kMotions[] = {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away};

std::vector<Shape> make_shapes(Random& random) {
  std::vector<Shape> shapes = {test::make_limb(20, 9, 6)};
  for (const std::uint32_t triangle_count : {1, 2, 5, 50, 203})
    shapes.push_back(make_soup(random, triangle_count, 6, 4, Weights::adversarial));
  return shapes;
}

std::vector<Vec3> posed_below(const SkinnedMesh& mesh, const Palette& palette,
                              const SphereTree& tree, const Node& node) {
  std::vector<Vec3> points;
  for (const std::uint32_t v : test::vertices_below(mesh, tree, node))
    points.push_back(detail::posed_vertex(mesh, palette, v));
  return points;
}

TEST(Eager, SpheresEncloseTheirPosedVerticesAndLeavesTightly) {
  Random random(1);
  int spheres = 0;
  for (const Shape& shape : make_shapes(random)) {
    const SkinnedMesh mesh = test::checked_mesh(shape);
    const SphereTree tree = build_sphere_tree(mesh.rest_positions, mesh.triangles);
    EagerBody body(mesh, tree);
    for (const Motion motion : kMotions) {
      const Palette palette = test::checked_palette(mesh, make_palette(random, 6, motion, 1));
      body.update(palette);
      for (std::uint32_t n = 0; n < tree.nodes.size(); ++n, ++spheres) {
        const Float4 sphere = body.spheres()[n];
        const auto points = posed_below(mesh, palette, tree, tree.nodes[n]);
        for (const Vec3& point : points)
          ASSERT_LE(test::relative_reach(sphere, point), 1) << "node " << n;
        if (!tree.nodes[n].is_leaf()) continue;
        const double rounding = 0x1p-20 * static_cast<double>(palette.reach());
        ASSERT_LE(sphere[3], 1.01 * static_cast<double>(min_sphere(points).radius) + rounding);
      }
    }
  }
  EXPECT_GT(spheres, 3000);
}

TEST(Eager, SpheresEncloseTheSpheresOfTheirChildren) {
  Random random(2);
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(20, 9, 6));
  const SphereTree tree = build_sphere_tree(mesh.rest_positions, mesh.triangles);
  EagerBody body(mesh, tree);
  body.update(test::checked_palette(mesh, bend_limb(random, 6, 0.4, {})));
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t c = 0; c < tree.nodes[n].child_count; ++c) {
      const Float4 parent = body.spheres()[n],
                   child = body.spheres()[tree.nodes[n].first_child + c];
      const double distance = std::sqrt(static_cast<double>(squared_distance(parent, child)));
      ASSERT_LE(distance + static_cast<double>(child[3]),
                static_cast<double>(parent[3]) * 1.000001);
    }
}

TEST(Eager, CountsAllVerticesAndAllSpheres) {
  Random random(3);
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(20, 9, 6));
  const SphereTree tree = build_sphere_tree(mesh.rest_positions, mesh.triangles);
  EagerBody body(mesh, tree);
  const QueryStats work =
      body.update(test::checked_palette(mesh, make_palette(random, 6, Motion::rigid, 1)));
  EXPECT_EQ(work.posed_vertices, mesh.vertex_count());
  EXPECT_EQ(work.refits, tree.nodes.size());
}

}  // namespace
}  // namespace pelt::paper
