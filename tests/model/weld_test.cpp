#include "model/weld.hpp"

#include "meshes.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"
#include "support/closed_shapes.hpp"

#include <cstring>

namespace pelt::detail {
namespace {

using test::Random;
using test::Shape;

/// Four equal vertices of two influences.
Shape four_alike() {
  Shape shape;
  shape.rest_positions.assign(4, {1, 2, 3});
  shape.triangles = {{0, 1, 2}, {1, 2, 3}};
  shape.influences_per_vertex = 2;
  shape.joints = {0, 1, 0, 1, 0, 1, 0, 1};
  shape.weights = {0.25f, 0.75f, 0.25f, 0.75f, 0.25f, 0.75f, 0.25f, 0.75f};
  shape.joint_count = 3;
  return shape;
}

using Numbers = std::vector<std::uint32_t>;

Numbers weld(const Shape& shape) { return weld_vertices(test::mesh_of(shape)); }

TEST(Weld, TheLowestNumberStandsForAll) { EXPECT_EQ(weld(four_alike()), (Numbers{0, 0, 0, 0})); }

TEST(Weld, KeepsWhatDiffersInOnePosition) {
  Shape shape = four_alike();
  shape.rest_positions[1].z = 4;
  EXPECT_EQ(weld(shape), (Numbers{0, 1, 0, 0}));
}

TEST(Weld, KeepsZerosOfDifferentSign) {
  Shape shape = four_alike();
  for (Vec3& p : shape.rest_positions) p.x = 0;
  shape.rest_positions[2].x = -0.0f;
  EXPECT_EQ(weld(shape), (Numbers{0, 0, 2, 0})) << "they may be posed to other bits";
}

TEST(Weld, KeepsWhatDiffersInJointsOrWeights) {
  Shape shape = four_alike();
  shape.joints[3] = 2;
  shape.weights[4] = 0.5f, shape.weights[5] = 0.5f;
  EXPECT_EQ(weld(shape), (Numbers{0, 1, 2, 0}));
}

TEST(Weld, KeepsWhatHasMoreInfluences) {
  Shape shape = four_alike();
  for (std::size_t v = 0; v < 4; ++v) shape.weights[2 * v] = 1, shape.weights[2 * v + 1] = 1e-30f;
  shape.weights[3] = shape.weights[7] = 0;
  EXPECT_EQ(weld(shape), (Numbers{0, 1, 0, 1})) << "the first influences of all are the same";
}

TEST(Weld, IgnoresTheOrderInWhichAFileNamesJoints) {
  Shape shape = four_alike();
  std::swap(shape.joints[4], shape.joints[5]);
  std::swap(shape.weights[4], shape.weights[5]);
  EXPECT_EQ(weld(shape), (Numbers{0, 0, 0, 0}));
}

TEST(Weld, OnlyTheSurfaceIgnoresTheSignOfZero) {
  Shape shape = four_alike();
  shape.rest_positions = {{0, 2, 3}, {-0.0F, 2, 3}, {0, 2, 3}, {1, 2, 3}};
  const SkinnedMesh mesh = test::mesh_of(shape);
  EXPECT_EQ(weld_vertices(mesh), (Numbers{0, 1, 0, 3}));
  EXPECT_EQ(weld_surface(mesh), (Numbers{0, 0, 0, 3}));
}

bool same_vertex(const SkinnedMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto of_a = mesh.influences_of(a), of_b = mesh.influences_of(b);
  return of_a.size() == of_b.size() &&
         std::memcmp(of_a.data(), of_b.data(), of_a.size_bytes()) == 0 &&
         std::memcmp(&mesh.rest_positions[a], &mesh.rest_positions[b], sizeof(Vec3)) == 0;
}

TEST(Weld, IsWhatComparingAllPairsFinds) {
  Random random(71);
  Shape shape = test::make_soup(random, 120, 5, 3, test::Weights::adversarial);
  test::split_at_seams(shape, random, 0.5);
  const SkinnedMesh mesh = test::mesh_of(shape);
  const Numbers welded = weld_vertices(mesh);
  std::uint32_t alike = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    std::uint32_t lowest = 0;
    while (!same_vertex(mesh, lowest, v)) ++lowest;
    ASSERT_EQ(welded[v], lowest) << v;
    alike += lowest != v;
  }
  EXPECT_GT(alike, 100u);
  EXPECT_LT(alike, mesh.vertex_count() - 50);
}

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
