#include "paper/refit.hpp"
#include "paper/eager.hpp"
#include "paper/min_sphere.hpp"
#include "paper/on_demand.hpp"
#include "paper/posed_mesh.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>

namespace pelt::paper {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

constexpr Motion kMotions[] = {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away};
constexpr BoundKind kKinds[] = {BoundKind::optimised, BoundKind::plain};

std::vector<Vec3> posed(const SkinnedMesh& mesh, const Palette& palette) {
  std::vector<Vec3> positions(mesh.vertex_count());
  detail::posed_vertices(mesh, palette, positions);
  return positions;
}

/// Number of checked spheres and vertices, and the largest relative reach of a vertex.
struct Enclosed {
  std::uint64_t spheres = 0, vertices = 0, near_surface = 0;
};

/// Checks every sphere of one pose.
void expect_enclosing(const SkinnedMesh& mesh, const SphereModel& model, const Palette& palette,
                      Enclosed& enclosed) {
  const std::vector<Vec3> positions = posed(mesh, palette);
  Refit refit(model, mesh.joint_count);
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
    const Float4 sphere = refit.sphere(n, palette);
    double reach = 0;
    for (const std::uint32_t v : test::vertices_below(mesh, model.tree, model.tree.nodes[n])) {
      reach = std::max(reach, test::relative_reach(sphere, positions[v]));
      ++enclosed.vertices;
    }
    ASSERT_LE(reach, 1) << "node " << n;
    ++enclosed.spheres;
    enclosed.near_surface += reach > 0.999;
  }
}

TEST(Refit, EnclosesTheFloatVerticesOfSoupsUnderAnyMotionWeightsAndInfluences) {
  Random random(1);
  Enclosed enclosed;
  for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
    for (const std::uint32_t influences : {1, 2, 3, 4, 6, 8, 9, 12}) {
      const SkinnedMesh mesh = test::checked_mesh(make_soup(random, 48, 14, influences, weights));
      for (const BoundKind kind : kKinds) {
        const SphereModel model = build_sphere_model(mesh, kind);
        for (const Motion motion : kMotions)
          for (const double spread : {0.0, 1.0, 1000.0}) {
            const Palette palette =
                test::checked_palette(mesh, make_palette(random, 14, motion, spread));
            ASSERT_NO_FATAL_FAILURE(expect_enclosing(mesh, model, palette, enclosed));
          }
      }
    }
  EXPECT_GT(enclosed.spheres, 30000u);
  EXPECT_GT(enclosed.near_surface, enclosed.spheres / 10);
}

TEST(Refit, EnclosesTheFloatVerticesOfLimbs) {
  Random random(2);
  Enclosed enclosed;
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(24, 10, 6));
  for (const BoundKind kind : kKinds) {
    const SphereModel model = build_sphere_model(mesh, kind);
    for (int i = 0; i < 5; ++i) {
      const auto bent = bend_limb(random, 6, random.uniform(0, 1.5), random.point(100));
      ASSERT_NO_FATAL_FAILURE(
          expect_enclosing(mesh, model, test::checked_palette(mesh, bent), enclosed));
      for (const Motion motion : kMotions) {
        const auto palette = test::checked_palette(mesh, make_palette(random, 6, motion, 1));
        ASSERT_NO_FATAL_FAILURE(expect_enclosing(mesh, model, palette, enclosed));
      }
    }
  }
  EXPECT_GT(enclosed.spheres, 20000u);
}

TEST(Refit, EnclosesVerticesOfTinyAndHugeModels) {
  Random random(3);
  Enclosed enclosed;
  for (const float scale : {1e-15f, 1e-6f, 1e6f, 1e14f}) {
    Shape shape = make_soup(random, 48, 5, 4, Weights::random);
    for (Vec3& v : shape.rest_positions) v = {scale * v.x, scale * v.y, scale * v.z};
    const SkinnedMesh mesh = test::checked_mesh(shape);
    const SphereModel model = build_sphere_model(mesh);
    for (const Motion motion : kMotions) {
      const double spread = static_cast<double>(scale);
      const Palette palette = test::checked_palette(mesh, make_palette(random, 5, motion, spread));
      ASSERT_NO_FATAL_FAILURE(expect_enclosing(mesh, model, palette, enclosed));
    }
  }
  EXPECT_GT(enclosed.spheres, 500u);
}

/// Triangles that collapse to one vertex: their spheres consist of rounding margins only.
Shape make_points(Random& random, std::uint32_t influences) {
  Shape shape = make_soup(random, 64, 14, influences, Weights::adversarial);
  shape.triangles.clear();
  for (std::uint32_t v = 0; v < shape.rest_positions.size(); ++v)
    shape.triangles.push_back({v, v, v});
  return shape;
}

TEST(Refit, EnclosesASingleVertexByItsMarginAlone) {
  Random random(8);
  int leaves = 0, off_centre = 0;
  for (const std::uint32_t influences : {1, 2, 4, 8, 12})
    for (const Motion motion : kMotions) {
      const SkinnedMesh mesh = test::checked_mesh(make_points(random, influences));
      const SphereModel model = build_sphere_model(mesh);
      const Palette palette = test::checked_palette(mesh, make_palette(random, 14, motion, 1));
      Refit refit(model, mesh.joint_count);
      for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
        const Node& node = model.tree.nodes[n];
        if (!node.is_leaf()) continue;
        const std::uint32_t v = mesh.triangles[model.tree.triangle_of_leaf(node)][0];
        const Float4 sphere = refit.sphere(n, palette);
        const double reach = test::relative_reach(sphere, detail::posed_vertex(mesh, palette, v));
        ASSERT_LE(reach, 1);
        ASSERT_LE(sphere[3], test::rounding_room(model, palette, 0));
        off_centre += reach > 0;
        ++leaves;
      }
    }
  EXPECT_GT(off_centre, leaves / 4);
}

TEST(Refit, KeepsTheRestRadiusWhereAllVerticesFollowOneRigidJoint) {
  Random random(4);
  int nodes = 0;
  const SkinnedMesh mesh = test::checked_mesh(make_soup(random, 300, 2, 1, Weights::one_joint));
  const SphereModel model = build_sphere_model(mesh);
  const Palette palette = test::checked_palette(mesh, make_palette(random, 2, Motion::rigid, 1));
  Refit refit(model, 2);
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
    if (model.bounds.sets_of(n).size() > 1) continue;
    const float rest = model.tree.nodes[n].rest.radius, radius = refit.sphere(n, palette)[3];
    ASSERT_GE(radius, rest);
    ASSERT_LE(radius, rest + test::rounding_room(model, palette, static_cast<double>(rest)));
    ++nodes;
  }
  EXPECT_GT(nodes, 50);
}

TEST(Refit, RefitsEachNodeAtMostOnceForEachPalette) {
  Random random(5);
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(10, 8, 4));
  const SphereModel model = build_sphere_model(mesh);
  const auto node_count = static_cast<std::uint32_t>(model.tree.nodes.size());
  Refit refit(model, 4);
  std::uint64_t expected = 0;
  for (int pose = 0; pose < 3; ++pose) {
    const auto palette = test::checked_palette(mesh, make_palette(random, 4, Motion::rigid, 1));
    refit.invalidate();
    EXPECT_EQ(refit.refits(), expected);  // no refit before the first use
    refit.sphere(3, palette);
    refit.sphere(3, palette);
    EXPECT_EQ(refit.refits(), expected + 1);
    for (int again = 0; again < 2; ++again)
      for (std::uint32_t n = 0; n < node_count; ++n) refit.sphere(n, palette);
    expected += node_count;
    EXPECT_EQ(refit.refits(), expected);
  }
}

using Bits = std::array<std::uint32_t, 4>;

Bits bits_of(const Float4& sphere) {
  Bits bits{};
  for (std::size_t lane = 0; lane < 4; ++lane)
    bits[lane] = std::bit_cast<std::uint32_t>(sphere[static_cast<int>(lane)]);
  return bits;
}

TEST(Refit, GivesTheSameBitsInAnyOrderOfAsking) {
  Random random(6);
  const SkinnedMesh mesh = test::checked_mesh(make_soup(random, 100, 6, 4, Weights::adversarial));
  const SphereModel model = build_sphere_model(mesh);
  const Palette palette = test::checked_palette(mesh, make_palette(random, 6, Motion::affine, 1));
  const Palette before = test::checked_palette(mesh, make_palette(random, 6, Motion::rigid, 9));
  std::vector<std::uint32_t> order(model.tree.nodes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Bits> first;
  Refit forward(model, 6);
  for (const std::uint32_t n : order) first.push_back(bits_of(forward.sphere(n, palette)));
  for (int i = 0; i < 5; ++i) {
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[random.index(static_cast<std::uint32_t>(k))]);
    Refit shuffled(model, 6);
    for (std::size_t k = 0; k < order.size() / 2; ++k) shuffled.sphere(order[k], before);
    shuffled.invalidate();  // earlier spheres leave no trace
    for (const std::uint32_t n : order)
      ASSERT_EQ(bits_of(shuffled.sphere(n, palette)), first[n]) << "node " << n;
  }
}

std::vector<float> refitted_radii(const SkinnedMesh& mesh, const SphereModel& model,
                                  const Palette& palette) {
  Refit refit(model, mesh.joint_count);
  std::vector<float> radii;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
    radii.push_back(refit.sphere(n, palette)[3]);
  return radii;
}

/// The last column of Table 2 of the paper: minimal spheres around the posed vertices.
std::vector<float> best_radii(const SkinnedMesh& mesh, const SphereModel& model,
                              const Palette& palette) {
  const std::vector<Vec3> positions = posed(mesh, palette);
  std::vector<float> radii;
  for (const Node& node : model.tree.nodes) {
    std::vector<Vec3> points;
    for (const std::uint32_t v : test::vertices_below(mesh, model.tree, node))
      points.push_back(positions[v]);
    radii.push_back(min_sphere(points).radius);
  }
  return radii;
}

TEST(Refit, IsTighterThanThePlainBoundAndNotFarFromTheBest) {
  Random random(7);
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(60, 16, 5));
  const SphereModel optimised = build_sphere_model(mesh);
  const SphereModel plain = build_sphere_model(mesh, BoundKind::plain);
  for (int i = 0; i < 5; ++i) {
    const auto palette =
        test::checked_palette(mesh, bend_limb(random, 5, random.uniform(0.15, 0.3), {}));
    const auto ours = level_statistics(optimised.tree, refitted_radii(mesh, optimised, palette));
    const auto loose = level_statistics(plain.tree, refitted_radii(mesh, plain, palette));
    const auto best = level_statistics(optimised.tree, best_radii(mesh, optimised, palette));
    for (std::size_t level = 0; level < ours.size(); ++level) {
      EXPECT_GE(ours[level].mean_radius, best[level].mean_radius);
      EXPECT_LE(ours[level].mean_radius, 1.7 * best[level].mean_radius);
      EXPECT_LE(ours[level].mean_radius, 1.02 * loose[level].mean_radius);
    }
    const auto last = ours.size() - 1;
    EXPECT_LT(ours[last].mean_radius, loose[last].mean_radius / 3);
    std::printf("%.3f of the plain radius at the leaves\n",
                ours[last].mean_radius / loose[last].mean_radius);
  }
}

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
