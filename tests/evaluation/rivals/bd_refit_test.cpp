/// Every sphere of a BD-tree encloses the float32 posed vertices below it.

#include "evaluation/rivals/bd_tree.hpp"

#include "paper/posed_mesh.hpp"

#include <gtest/gtest.h>

namespace pelt::rivals {
namespace {

using detail::SkinnedMesh;
using test::Motion;
using test::Random;
using test::Weights;

/// The relative reach of vertices in their spheres: the largest, and the mean over the nodes.
struct Reach {
  double farthest = 0, sum = 0;
  std::uint32_t nodes = 0;

  void add(const SkinnedMesh& mesh, const BdModel& model, const Palette& palette) {
    BdRefit refit(model, mesh.joint_count);
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
      refit.refit(n, palette);
      double reach = 0;
      for (const std::uint32_t v : test::vertices_below(mesh, model.tree, model.tree.nodes[n]))
        reach = std::max(reach, test::relative_reach(refit.spheres()[n],
                                                     detail::posed_vertex(mesh, palette, v)));
      farthest = std::max(farthest, reach);
      sum += reach;
      ++nodes;
    }
  }
};

TEST(BdRefit, SpheresOfSoupsEncloseTheirVertices) {
  Random random(1);
  Reach reach;
  for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (int i = 0; i < 8; ++i) {
        const std::uint32_t joints = 1 + random.index(12);
        const SkinnedMesh mesh = test::checked_mesh(make_soup(random, 60, joints, 4, weights));
        const BdModel model(mesh);
        const auto palette = make_palette(random, joints, motion, random.uniform(0, 3));
        reach.add(mesh, model, test::checked_palette(mesh, palette));
      }
  std::printf("farthest %.9f, mean %.3f of the radius in %u nodes\n", reach.farthest,
              reach.sum / reach.nodes, reach.nodes);
  EXPECT_LE(reach.farthest, 1);
  EXPECT_GT(reach.farthest, 0.99);  // some sphere is tight
}

TEST(BdRefit, SpheresOfLimbsEncloseTheirVerticesAndAreNotMuchLarger) {
  Random random(2);
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(24, 12, 6));
  const BdModel model(mesh);
  Reach reach;
  for (int i = 0; i < 10; ++i)
    reach.add(mesh, model, test::checked_palette(mesh, bend_limb(random, 6, 0.4, random.point(2))));
  std::printf("farthest %.9f, mean %.3f of the radius\n", reach.farthest, reach.sum / reach.nodes);
  EXPECT_LE(reach.farthest, 1);
  EXPECT_GT(reach.sum / reach.nodes, 0.5);
}

TEST(BdRefit, GivesTheSameSpheresInAnyOrder) {
  Random random(3);
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(12, 8, 5));
  const BdModel model(mesh);
  const Palette palette = test::checked_palette(mesh, bend_limb(random, 5, 0.4, {}));
  const auto count = static_cast<std::uint32_t>(model.tree.nodes.size());
  BdRefit forward(model, mesh.joint_count), backward(model, mesh.joint_count);
  for (std::uint32_t n = 0; n < count; ++n) forward.refit(n, palette);
  for (std::uint32_t n = count; n-- > 0;) backward.refit(n, palette);
  for (std::uint32_t n = 0; n < count; ++n)
    for (int lane = 0; lane < 4; ++lane)
      ASSERT_EQ(forward.spheres()[n][lane], backward.spheres()[n][lane]) << n;
  EXPECT_EQ(forward.refits(), count);
  forward.invalidate();
  EXPECT_TRUE(forward.is_stale(count / 2));
}

}  // namespace
}  // namespace pelt::rivals
