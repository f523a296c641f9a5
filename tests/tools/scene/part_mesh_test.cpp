#include "tools/pelt/scene/colliders.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::scene {
namespace {

/// `count` parts of one triangle; triangle t has the vertices t, 2 count - 1 - t, 2 count + t.
asset::Asset many_parts(std::uint32_t count) {
  asset::Asset asset;
  asset.joints.resize(1);
  asset.nodes.resize(1);
  asset.influences_per_vertex = 1;
  for (std::uint32_t v = 0; v < 3 * count; ++v) {
    const auto x = static_cast<float>(v);
    asset.rest_positions.push_back({x, x * x, 1});
    asset.joint_indices.push_back(0);
    asset.weights.push_back(1);
  }
  for (std::uint32_t t = 0; t < count; ++t) {
    asset.triangles.push_back({t, 2 * count - 1 - t, 2 * count + t});
    asset::Part part;
    part.first_triangle = t;
    part.triangle_count = 1;
    asset.parts.push_back(part);
  }
  return asset;
}

TEST(PartMesh, HasTheVerticesThatItsTrianglesUse) {
  const asset::Asset asset = many_parts(2);
  const PartMesh mesh(asset.mesh(), asset.parts[1]);
  const SkinnedMeshView view = mesh.view();
  ASSERT_EQ(view.rest_positions.size(), 3u);
  EXPECT_EQ(view.triangles.size(), 1u);
  for (std::size_t corner = 0; corner < 3; ++corner)
    EXPECT_EQ(view.rest_positions[view.triangles[0][corner]],
              asset.rest_positions[asset.triangles[1][corner]]);
  EXPECT_TRUE(build_model(view));
}

TEST(PartMesh, HasTheMorphTargetsThatDisplaceItsVertices) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {4, 1, 3}};
  const std::vector<std::uint16_t> joints(5, 0);
  const std::vector<float> weights(5, 1);
  const std::vector<std::uint32_t> begin = {0, 3, 3, 5}, vertices = {0, 1, 3, 2, 4};
  const std::vector<Vec3> displacements = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}};
  const SkinnedMeshView whole = {
      positions, triangles, 1, joints, weights, 1, {begin, vertices, displacements}};
  asset::Part part;
  part.first_triangle = 1;
  part.triangle_count = 1;
  const PartMesh mesh(whole, part);
  const MorphTargetsView morphs = mesh.view().morph_targets;
  EXPECT_EQ(std::vector<std::uint32_t>(morphs.begin.begin(), morphs.begin.end()),
            (std::vector<std::uint32_t>{0, 2, 3}));
  EXPECT_EQ(mesh.morph_targets(), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(std::vector<std::uint32_t>(morphs.vertices.begin(), morphs.vertices.end()),
            (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(morphs.displacements[0], (Vec3{2, 0, 0}));
  EXPECT_EQ(morphs.displacements[1], (Vec3{3, 0, 0}));
  EXPECT_EQ(morphs.displacements[2], (Vec3{5, 0, 0}));
}

TEST(PartMesh, HasTheJointsThatItsVerticesFollow) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> triangles = {{0, 1, 3}, {1, 2, 3}};
  const std::vector<std::uint16_t> joints = {5, 0, 2, 4, 7, 2, 4, 6};
  const std::vector<float> weights = {1, 0, 0.5f, 0.5f, 1, 0, 0.25f, 0.75f};
  asset::Part part;
  part.first_triangle = 1;
  part.triangle_count = 1;
  const PartMesh mesh({positions, triangles, 2, joints, weights, 8}, part);
  EXPECT_EQ(mesh.joints(), (std::vector<std::uint16_t>{2, 4, 6, 7}));
  EXPECT_EQ(mesh.view().joint_count, 4u);
  const std::span<const std::uint16_t> numbers = mesh.view().joints;
  EXPECT_EQ(std::vector<std::uint16_t>(numbers.begin(), numbers.end()),
            (std::vector<std::uint16_t>{0, 1, 3, 0, 1, 2}));
  EXPECT_TRUE(build_model(mesh.view()));
}

TEST(PartMesh, MakesCollidersWhoseMemoryDoesNotGrowWithTheOtherParts) {
  const auto bytes_of = [](std::uint32_t parts) {
    scenes::Scene scene;
    scene.characters.push_back({"dust", "dust.glb", 0, many_parts(parts)});
    scene.instances.resize(1);
    const auto colliders = make_colliders(scene, Granularity::part, {});
    EXPECT_TRUE(colliders) << colliders.error().message;
    EXPECT_EQ(colliders->size(), parts);
    EXPECT_EQ(colliders->back().model.vertex_count(), 3u);
    std::size_t bytes = 0;
    for (const Collider& collider : *colliders) bytes += collider.model.memory_bytes();
    return bytes;
  };
  EXPECT_LE(bytes_of(200), 2 * bytes_of(100));
}

}  // namespace
}  // namespace pelt::tools::scene
