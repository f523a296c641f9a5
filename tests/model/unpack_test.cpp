#include "model/unpack.hpp"

#include "meshes.hpp"
#include "model/tree_build.hpp"
#include "support/closed_shapes.hpp"

namespace pelt::detail {
namespace {

TEST(Unpack, TrianglesNameTheLowestOfBitIdenticalVertices) {
  const test::Shape shape = test::make_rigid(
      {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {{3, 4, 5}, {1, 2, 3}});
  const SkinnedMesh mesh = test::mesh_of(shape);
  const SkinnedMesh unpacked = unpack_mesh(build_tree(mesh, test::rest_only(mesh)));
  EXPECT_EQ(unpacked.triangles, (std::vector<Triangle>{{3, 2, 5}, {1, 2, 3}}));
  EXPECT_EQ(unpacked.rest_positions, shape.rest_positions);
  EXPECT_EQ(unpacked.influences.size(), 6u);
}

TEST(Unpack, VerticesLieAsInTheTree) {
  const SkinnedMesh mesh = test::mesh_of(test::make_limb(30, 12, 4));
  const Tree tree = build_tree(mesh, test::rest_only(mesh));
  const SkinnedMesh vertices = unpack_vertices(tree);
  EXPECT_EQ(vertices.rest_positions, tree.rest_positions);
  EXPECT_EQ(vertices.triangle_count(), 0u);
  ASSERT_EQ(vertices.influences.size(), tree.joints.size());
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    EXPECT_EQ(vertices.influences[i].joint, tree.joints[i]);
    EXPECT_EQ(vertices.influences[i].weight, tree.weights[i]);
  }
}

}  // namespace
}  // namespace pelt::detail
