#include "model/surface.hpp"
#include "model/meshes.hpp"
#include "model/model.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"
#include "model/weld.hpp"
#include "support/closed_shapes.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

namespace pelt::test {
namespace {

SkinnedModel model_of(const Shape& shape) { return *build_model(shape.view()); }

TEST(Surface, OfALimbIsClosed) { EXPECT_TRUE(model_of(make_limb(12, 9, 3)).surface().is_closed()); }

TEST(Surface, IsMadeOnceForAllCopiesOfAModel) {
  const SkinnedModel model = model_of(make_limb(12, 9, 3)), copy = model;
  std::vector<const detail::Surface*> seen(8);
  std::vector<std::thread> threads;
  for (const detail::Surface*& surface : seen)
    threads.emplace_back([&] { surface = &copy.surface().detail(); });
  for (std::thread& thread : threads) thread.join();
  for (const detail::Surface* surface : seen) EXPECT_EQ(surface, &model.surface().detail());
}

TEST(Surface, OutlivesTheModelThatMadeIt) {
  const Surface surface = model_of(make_limb(12, 9, 3)).surface();
  EXPECT_TRUE(surface.is_closed());
}

TEST(Surface, WithAHoleIsNotClosed) {
  Shape limb = make_limb(12, 9, 3);
  limb.triangles.pop_back();
  EXPECT_FALSE(model_of(limb).surface().is_closed());
}

TEST(Surface, WithATriangleTurnedRoundIsNotClosed) {
  Shape limb = make_limb(12, 9, 3);
  std::swap(limb.triangles[5][0], limb.triangles[5][1]);
  EXPECT_FALSE(model_of(limb).surface().is_closed());
}

/// A limb in which no two triangles share a vertex index.
Shape split_limb() {
  const Shape limb = make_limb(12, 9, 3);
  Shape split = limb;
  split.rest_positions.clear();
  split.joints.clear();
  split.weights.clear();
  const std::uint32_t k = limb.influences_per_vertex;
  for (Triangle& triangle : split.triangles)
    for (std::uint32_t& vertex : triangle) {
      split.rest_positions.push_back(limb.rest_positions[vertex]);
      for (std::uint32_t i = 0; i < k; ++i) {
        split.joints.push_back(limb.joints[vertex * k + i]);
        split.weights.push_back(limb.weights[vertex * k + i]);
      }
      vertex = static_cast<std::uint32_t>(split.rest_positions.size() - 1);
    }
  return split;
}

TEST(Surface, IsClosedAcrossSeams) { EXPECT_TRUE(model_of(split_limb()).surface().is_closed()); }

TEST(Surface, IsOpenAlongSeamsThatTheModelHasNotMerged) {
  const Shape split = split_limb();
  EXPECT_FALSE(build_model(split.view(), {.weld = false})->surface().is_closed());
  SkinnedMeshView view = split.view();
  std::vector<float> caps(split.rest_positions.size(), 0);
  view.offset_caps = caps;
  EXPECT_TRUE(build_model(view)->surface().is_closed());
  caps[5] = 0.25f;
  EXPECT_FALSE(build_model(view)->surface().is_closed());
}

TEST(Surface, OfATriangleWithARepeatedVertexIsNotClosed) {
  Shape shape = make_limb(12, 9, 3);
  for (const Triangle& triangle : {Triangle{3, 3, 7}, {3, 7, 3}, {7, 3, 3}, {5, 5, 5}}) {
    shape.triangles = {triangle};
    EXPECT_FALSE(model_of(shape).surface().is_closed());
  }
}

/// The poles of a sphere made of quads have such triangles.
TEST(Surface, StaysClosedWithTrianglesThatRepeatAVertex) {
  Shape limb = make_limb(12, 9, 3);
  const auto [a, b, c] = limb.triangles[5];
  limb.triangles.push_back({a, b, b});
  limb.triangles.push_back({c, c, c});
  EXPECT_TRUE(model_of(limb).surface().is_closed());
}

TEST(Surface, NamesTheJointThatATriangleFollowsMost) {
  Shape shape;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}};
  shape.influences_per_vertex = 2;
  shape.joint_count = 3;
  shape.joints = {0, 1, 1, 2, 2, 1};
  shape.weights = {0.75f, 0.25f, 0.5f, 0.5f, 0.75f, 0.25f};  // 0.75, 1, 1.25
  EXPECT_EQ(model_of(shape).surface().detail().joints[0], 2);
  shape.weights = {1, 0, 0.75f, 0.25f, 0.75f, 0.25f};  // 1, 1, 1
  EXPECT_EQ(model_of(shape).surface().detail().joints[0], 0);
}

}  // namespace
}  // namespace pelt::test

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
