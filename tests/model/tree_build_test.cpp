#include <pelt/asset.hpp>

#include "model/check_tree.hpp"
#include "model/meshes.hpp"
#include "model/model.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"
#include "model/weld.hpp"
#include "skin/skin.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace pelt::detail {
namespace {

using test::Random;
using test::Shape;

Tree build_sound(const SkinnedMesh& mesh, std::span<const std::vector<Vec3>> samples) {
  Tree tree = build_tree(mesh, samples);
  EXPECT_EQ(check_tree(tree), "");
  return tree;
}

Tree build_sound(const SkinnedMesh& mesh) { return build_sound(mesh, test::rest_only(mesh)); }

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Expects every vertex and every triangle, up to the choice between bit-identical vertices.
void expect_unpacks_to(const SkinnedMesh& mesh, const Tree& tree) {
  const SkinnedMesh unpacked = unpack_mesh(tree);
  EXPECT_TRUE(same_bits(unpacked.rest_positions, mesh.rest_positions));
  EXPECT_TRUE(same_bits(unpacked.influence_begin, mesh.influence_begin));
  EXPECT_TRUE(same_bits(unpacked.influences, mesh.influences));
  EXPECT_EQ(unpacked.joint_count, mesh.joint_count);
  EXPECT_EQ(unpacked.rest_extent, mesh.rest_extent);
  ASSERT_EQ(unpacked.triangle_count(), mesh.triangle_count());
  const std::vector<std::uint32_t> welded = weld_vertices(mesh);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(unpacked.triangles[t][k], welded[mesh.triangles[t][k]]) << t;
}

void expect_round_trip(const Shape& shape) {
  const SkinnedMesh mesh = test::mesh_of(shape);
  expect_unpacks_to(mesh, build_sound(mesh));
}

TEST(TreeBuild, KeepsEveryTriangleAndVertexOfALimb) {
  expect_round_trip(test::make_limb(60, 24, 5));
  expect_round_trip(test::make_limb(3, 3, 1));
}

TEST(TreeBuild, KeepsEveryTriangleAndVertexOfSoups) {
  Random random(81);
  for (const auto weights :
       {test::Weights::one_joint, test::Weights::random, test::Weights::adversarial})
    for (const std::uint32_t count : {1u, 16u, 17u, 150u, 2000u})
      for (const std::uint32_t influences : {1u, 4u, 9u})
        expect_round_trip(test::make_soup(random, count, 12, influences, weights));
}

TEST(TreeBuild, WeldsSeams) {
  Random random(82);
  Shape shape = test::make_limb(40, 16, 4);
  const Tree whole = build_sound(test::mesh_of(shape));
  test::split_at_seams(shape, random, 0.4);
  const SkinnedMesh mesh = test::mesh_of(shape);
  const Tree tree = build_sound(mesh);
  expect_unpacks_to(mesh, tree);
  EXPECT_GT(tree.vertex_count(), whole.vertex_count() + 1000);
  EXPECT_EQ(tree.rest_positions.size(), whole.rest_positions.size());
}

TEST(TreeBuild, PutsUnusedVerticesLast) {
  Shape shape = test::make_limb(10, 8, 2);
  shape.rest_positions[3].x = 5;  // used, but different from its copies below
  const std::uint32_t used = static_cast<std::uint32_t>(shape.rest_positions.size());
  for (const std::uint32_t v : {3u, 7u}) test::split_vertex(shape, v);
  shape.rest_positions[used].x = 6;
  test::split_vertex(shape, used);
  const SkinnedMesh mesh = test::mesh_of(shape);
  const Tree tree = build_sound(mesh);
  expect_unpacks_to(mesh, tree);
  EXPECT_EQ(tree.vertex_places[used], tree.rest_positions.size() - 1);
  EXPECT_EQ(tree.vertex_places[used + 2], tree.rest_positions.size() - 1) << "its copy";
  const Node& last = tree.nodes.back();
  EXPECT_EQ(last.first_vertex + last.vertex_count, tree.rest_positions.size() - 1);
}

TEST(TreeBuild, PoolsAreSharedByTheClustersOfANode) {
  const SkinnedMesh mesh = test::mesh_of(test::make_limb(120, 40, 6));
  const Tree tree = build_sound(mesh);
  EXPECT_LT(tree.rest_positions.size(), mesh.triangle_count() * 4 / 5);
  EXPECT_LT(tree.rest_positions.size(), tree.cluster_vertices.size() * 9 / 10);
}

void expect_no_spare(const Tree& tree) {
  EXPECT_EQ(tree.rest_positions.capacity(), tree.rest_positions.size());
  EXPECT_EQ(tree.influence_begin.capacity(), tree.influence_begin.size());
  EXPECT_EQ(tree.joints.capacity(), tree.joints.size());
  EXPECT_EQ(tree.weights.capacity(), tree.weights.size());
  EXPECT_EQ(tree.corners.capacity(), tree.corners.size());
  EXPECT_EQ(tree.triangle_ids.capacity(), tree.triangle_ids.size());
  EXPECT_EQ(tree.cluster_vertices.capacity(), tree.cluster_vertices.size());
  EXPECT_EQ(tree.clusters.capacity(), tree.clusters.size());
  EXPECT_EQ(tree.nodes.capacity(), tree.nodes.size());
  EXPECT_EQ(tree.vertex_places.capacity(), tree.vertex_places.size());
}

TEST(TreeBuild, WastesNoMemory) {
  for (const std::uint32_t rings : {50u, 70u, 110u})
    expect_no_spare(build_sound(test::mesh_of(test::make_limb(rings, 20, 3))));
}

/// Poses of the limb, the rest pose first.
std::vector<std::vector<Vec3>> limb_samples(const SkinnedMesh& mesh, Random& random) {
  std::vector<std::vector<Vec3>> samples = {mesh.rest_positions};
  for (int s = 0; s < 4; ++s) {
    std::vector<float> floats;
    for (const Matrix4& joint : test::bend_limb(random, mesh.joint_count, 0.7, {}))
      floats.insert(floats.end(), joint.m.begin(), joint.m.end());
    Palette palette(mesh.joint_count, mesh.rest_extent);
    EXPECT_TRUE(palette.set(floats));
    samples.emplace_back(mesh.vertex_count());
    posed_vertices(mesh, palette, samples.back());
  }
  return samples;
}

TEST(TreeBuild, SamplePosesShapeTheTreeAndNothingElse) {
  Random random(83);
  const SkinnedMesh mesh = test::mesh_of(test::make_limb(100, 20, 8));
  const Tree tree = build_sound(mesh, limb_samples(mesh, random));
  expect_unpacks_to(mesh, tree);
  EXPECT_NE(tree.triangle_ids, build_sound(mesh).triangle_ids);
}

class SharedModelTrees : public ::testing::TestWithParam<const char*> {};

TEST_P(SharedModelTrees, AreSoundAndSmall) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const auto asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  BuildReport report;
  ModelOptions options;
  options.off_weights = OffWeights::renormalise;
  const auto mesh = make_skinned_mesh(asset->mesh(), options, report);
  ASSERT_TRUE(mesh) << mesh.error().message;
  const Tree tree = build_sound(*mesh);
  expect_unpacks_to(*mesh, tree);
  EXPECT_GT(mesh->triangle_count(), 12 * tree.clusters.size()) << "well-filled clusters";
  EXPECT_LT(tree.rest_positions.size(), mesh->triangle_count());
}

INSTANTIATE_TEST_SUITE_P(Models, SharedModelTrees,
                         ::testing::Values("human.glb", "human_8inf.glb", "knight.glb",
                                           "mannequin.glb", "spider.glb", "frog.glb"),
                         [](const auto& model) {
                           const std::string name = model.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pelt::detail

// SkinnedModel::memory_bytes counts every array.
namespace pelt {
namespace {

// The arrays that each_array visits, and those that are not in prepared files. If you add an array,
// add it there too.
static_assert(sizeof(detail::PoolMorphs) == 4 * sizeof(std::vector<int>));
static_assert(sizeof(detail::Tree) ==
              17 * sizeof(std::vector<int>) + sizeof(detail::PoolMorphs) + 16);
static_assert(sizeof(detail::NodeBounds) == 10 * sizeof(std::vector<int>));

template <typename... Array>
std::size_t bytes_of(const Array&... arrays) {
  return ((arrays.size() * sizeof(arrays[0])) + ...);
}

TEST(ModelMemory, CountsEveryArrayAndNeedsLittleMore) {
  test::Random random(335);
  test::Shape limb = test::make_limb(60, 40, 5);
  test::add_morph_targets(random, limb, 7, 0.3, 0.1);
  const auto model = build_model(limb.view());
  ASSERT_TRUE(model);
  const auto& [positions, begins, joints, weights, corners, ids, triangle_places, cluster_vertices,
               clusters, nodes, triangles_below, lowest_below, places, place_vertices, caps, welded,
               morphs, links, joint_count, extent, dual_influences] = model->detail().tree;
  const auto& bounds = model->detail().bounds;
  const std::size_t used =
      bytes_of(positions, begins, joints, weights, corners, ids, triangle_places, cluster_vertices,
               clusters, nodes, triangles_below, lowest_below, places, place_vertices, caps, welded,
               links) +
      bytes_of(morphs.extents, morphs.node_begin, morphs.targets, morphs.displacements) +
      bytes_of(bounds.nodes, bounds.joints, bounds.joint_boxes, bounds.shapes, bounds.fits,
               bounds.displacement_begin, bounds.displacements, bounds.dual_bounds,
               bounds.joint_pairs, bounds.offset_caps);
  EXPECT_GT(used, 10 * model->triangle_count());
  EXPECT_GE(model->memory_bytes(), used);
  EXPECT_LE(model->memory_bytes(), used * 5 / 4);
}

}  // namespace
}  // namespace pelt
