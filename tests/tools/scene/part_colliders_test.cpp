/// Parts have only the vertices, joints and morph targets that they use, and the same contacts,
/// joints and messages as whole instances.

#include "tools/pelt/scene/colliders.hpp"

#include "tools/pelt/check/frame_query.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/scene/walkers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

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

using test::colliders_of;
using test::palettes_of;

constexpr std::uint32_t kParts = 12;

/// Two faces, cut into parts, that talk inside each other.
scenes::Scene talkers() {
  scenes::Scene scene = test::talkers(2000);
  asset::Asset& asset = scene.characters[0].asset;
  const auto count = static_cast<std::uint32_t>(asset.triangles.size());
  asset.parts.assign(kParts, {});
  for (std::uint32_t p = 0; p < kParts; ++p) {
    asset.parts[p].first_triangle = count * p / kParts;
    asset.parts[p].triangle_count = count * (p + 1) / kParts - count * p / kParts;
  }
  return scene;
}

/// Triangle numbers of a contact of two instances, and its joints.
using Described = std::tuple<std::uint32_t, std::uint32_t, std::uint16_t, std::uint16_t>;

/// Contacts of different instances, ascending.
std::vector<Described> described(const check::Stage& stage, const FrameContacts& found,
                                 std::span<const ContactGeometry> geometry) {
  std::vector<Described> contacts;
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const Collider& a = stage.colliders[found.pairs[i].a];
    const Collider& b = stage.colliders[found.pairs[i].b];
    if (a.instance == b.instance) continue;
    for (const ContactTrace& trace : geometry[i].traces) {
      const Contact contact = numbered_in_assets(trace.contact, a, b);
      contacts.push_back({contact.triangle_a, contact.triangle_b, trace.joint_a, trace.joint_b});
    }
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

/// Contacts of different instances in each frame, ascending.
std::vector<std::vector<Described>> contacts_of(const scenes::Scene& scene,
                                                Granularity granularity) {
  check::CheckSettings settings;
  settings.granularity = granularity;
  settings.options.contacts = true;
  settings.frames = {0, scene.frame_count, 3};
  auto stage = check::Stage::make(scene, settings);
  EXPECT_TRUE(stage && stage->prepare());
  check::FrameQuery query(*stage, 1);
  std::vector<std::vector<Described>> frames;
  for (std::size_t i = 0; i < stage->frames.size(); ++i) {
    check::FrameAnswer answer;
    EXPECT_TRUE(query.ask(i, answer));
    frames.push_back(described(*stage, answer.found, query.geometry()));
  }
  return frames;
}

TEST(PartColliders, TouchWhereWholeInstancesTouchAndNameTheSameJoints) {
  const scenes::Scene scene = talkers();
  ASSERT_EQ(colliders_of(scene, Granularity::part).size(), 2 * kParts);
  const auto whole = contacts_of(scene, Granularity::instance);
  const auto parts = contacts_of(scene, Granularity::part);
  ASSERT_EQ(whole.size(), parts.size());
  std::size_t contacts = 0, displaced = 0;
  for (std::uint32_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(parts[i], whole[i]) << "frame " << 3 * i;
    contacts += whole[i].size();
    const Palettes palettes = palettes_of(scene, 3 * i);
    const auto& morphs = palettes.morphs[0];
    displaced += std::count_if(morphs.begin(), morphs.end(), [](float w) { return w != 0; }) > 0;
  }
  EXPECT_GT(contacts, 100u);
  EXPECT_GT(displaced, 0u);
}

TEST(PartColliders, HaveOnlyTheJointsAndMorphTargetsThatTheyFollow) {
  const scenes::Scene scene = talkers();
  const asset::Asset& asset = scene.characters[0].asset;
  std::size_t fewer_joints = 0, fewer_targets = 0, renumbered = 0;
  for (const Collider& part : colliders_of(scene, Granularity::part)) {
    EXPECT_EQ(part.model.joint_count(), part.rig->joints.size());
    EXPECT_EQ(part.model.morph_target_count(), part.rig->morph_targets.size());
    fewer_joints += part.model.joint_count() < asset.joints.size();
    fewer_targets += part.model.morph_target_count() < asset.morph_targets.size();
    renumbered += part.joint_in_asset(0) != 0;
  }
  EXPECT_GT(fewer_joints, 0u);
  EXPECT_GT(fewer_targets, 0u);
  EXPECT_GT(renumbered, 0u);
}

TEST(PartColliders, RefuseWhatWholeInstancesRefuseInTheSameWords) {
  const scenes::Scene scene = talkers();
  const std::vector<Collider> whole = colliders_of(scene, Granularity::instance);
  const std::vector<Collider> parts = colliders_of(scene, Granularity::part);
  const auto message_of = [](std::span<const Collider> colliders, const Palettes& palettes) {
    ScenePoses poses(colliders);
    const Result<void> set = poses.set_palettes(palettes);
    EXPECT_FALSE(set);
    SceneQuery query(colliders, methods::kOnDemand);
    EXPECT_EQ(query.set_palettes(palettes).error().message, set.error().message);
    return set.error().message;
  };
  Palettes palettes = palettes_of(scene, 3);
  palettes.joints[1].back().m[4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(message_of(parts, palettes), message_of(whole, palettes));
  EXPECT_EQ(message_of(parts, palettes).rfind("instances[1]: palette[6] has the element inf", 0),
            0u)
      << message_of(parts, palettes);
  palettes = palettes_of(scene, 3);
  palettes.morphs[0].back() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(message_of(parts, palettes), message_of(whole, palettes));
  EXPECT_EQ(message_of(parts, palettes), "instances[0]: morph_weights[5] is nan");
}

}  // namespace
}  // namespace pelt::tools::scene
