#include "paper/leaf_order.hpp"

#include "paper/posed_mesh.hpp"

namespace pelt::paper {
namespace {

void expect_same_vertex(const SkinnedMesh& mesh, std::uint32_t v, const SkinnedMesh& ordered,
                        std::uint32_t w) {
  ASSERT_EQ(ordered.rest_positions[w], mesh.rest_positions[v]);
  const auto expected = mesh.influences_of(v), actual = ordered.influences_of(w);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_EQ(actual[i].joint, expected[i].joint);
    ASSERT_EQ(actual[i].weight, expected[i].weight);
  }
}

TEST(LeafOrder, KeepsEveryTriangleUnderTheNumberOfItsLeaf) {
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(20, 9, 6));
  const SphereTree tree = build_sphere_tree(mesh.rest_positions, mesh.triangles);
  const SkinnedMesh ordered = in_leaf_order(mesh, tree);
  ASSERT_EQ(ordered.triangle_count(), mesh.triangle_count());
  std::uint32_t used = 0;  // vertices are numbered in the order in which triangles use them
  for (std::uint32_t t = 0; t < ordered.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t w = ordered.triangles[t][k];
      expect_same_vertex(mesh, mesh.triangles[tree.triangle_order[t]][k], ordered, w);
      ASSERT_LE(w, used);
      used += w == used;
    }
  EXPECT_EQ(used, ordered.vertex_count());
}

}  // namespace
}  // namespace pelt::paper
