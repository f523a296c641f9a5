/// Parts have only the joints and morph targets that they follow, and the same contacts, joints and
/// messages as whole instances.

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

using test::colliders_of;
using test::palettes_of;

constexpr std::uint32_t kParts = 12;

/// Two faces, cut into parts, that talk inside each other.
scenes::Scene talkers() {
  scenes::Scene scene;
  scene.characters.push_back(*scenes::generate_character(scenes::FaceOptions{2000, 1}));
  asset::Asset& asset = scene.characters[0].asset;
  const auto count = static_cast<std::uint32_t>(asset.triangles.size());
  asset.parts.assign(kParts, {});
  for (std::uint32_t p = 0; p < kParts; ++p) {
    asset.parts[p].first_triangle = count * p / kParts;
    asset.parts[p].triangle_count = count * (p + 1) / kParts - count * p / kParts;
  }
  scene.fps = 6;
  scene.frame_count = 12;
  scene.instances.resize(2);
  scene.instances[0].clip = scene.instances[1].clip = "talk";
  scene.instances[1].translation = {0.05, 0.02, 0.01};
  scene.instances[1].start = 0.4;
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
