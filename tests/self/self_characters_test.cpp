/// Real characters in all their clips, compared with brute force over the posed vertices.

#include <pelt/self.hpp>

#include "base/hash.hpp"
#include "scenes/creature.hpp"
#include "self/self_brute_force.hpp"
#include "support/animated_character.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <span>

namespace pelt::test {
namespace {

struct Case {
  const char* model;
  int frames;             ///< per clip
  std::size_t least_all;  ///< contacts in all frames, at least
  std::size_t most_clips = std::numeric_limits<std::size_t>::max();
};

/// A character, and what finds its contacts.
struct Actor {
  explicit Actor(AnimatedCharacter& moving)
      : character(moving),
        asset(moving.asset),
        surface(surface_vertices(asset.mesh())),
        pose(moving.pose),
        filter(*build_self_filter(pose.model())),
        without_neighbours(*build_self_filter(pose.model(), {.rings = 1})),
        tracker(filter) {}

  void move(const asset::Clip* clip, float seconds) {
    character.move(clip, seconds);
    std::vector<float> weights(asset.morph_targets.size());
    sample_morph_weights(asset, clip, seconds, weights);
    for (std::size_t m = 0; m < weights.size(); m += 3) weights[m] += 0.5f;
    ASSERT_TRUE(pose.set_morph_weights(weights));
  }

  bool are_neighbours(const Contact& contact) const {
    for (const std::uint32_t v : asset.triangles[contact.triangle_a])
      for (const std::uint32_t w : asset.triangles[contact.triangle_b])
        if (surface[v] == surface[w]) return true;
    return false;
  }

  /// Returns the number of contacts.
  std::size_t check() {
    std::vector<Contact> expected = sweep_self(posed_triangles(asset.mesh(), surface, pose));
    EXPECT_EQ(self_contacts_of(pose, filter, scratch), expected);
    EXPECT_EQ(self_intersects(pose, filter, scratch).answer, !expected.empty());
    const std::size_t count = expected.size();
    std::erase_if(expected, [&](const Contact& contact) { return are_neighbours(contact); });
    std::vector<Contact> found;
    const SelfStats stats = self_collide(pose, without_neighbours, scratch, found);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(stats.left_out.rings, count - expected.size());
    return count;
  }

  /// A tracker finds the same contacts.
  void track() {
    std::vector<Contact> tracked;
    self_collide(pose, tracker, scratch, tracked);
    EXPECT_EQ(tracked, self_contacts_of(pose, filter, scratch));
  }

  AnimatedCharacter& character;
  const asset::Asset& asset;
  std::vector<std::uint32_t> surface;
  Pose& pose;
  SelfFilter filter, without_neighbours;
  SelfTracker tracker;
  Scratch scratch;
};

using SelfCollideOfModels = OfSharedModels<Case>;

TEST_P(SelfCollideOfModels, EqualsBruteForce) {
  Actor actor(*character);
  EXPECT_LE(actor.filter.memory_bytes(), 40 * actor.asset.triangles.size() + 4096);
  actor.move(nullptr, 0);
  std::size_t contacts = actor.check();
  const std::size_t clips = std::min(actor.asset.clips.size(), GetParam().most_clips);
  for (const asset::Clip& clip : std::span(actor.asset.clips).first(clips))
    for (int frame = 1; frame <= GetParam().frames && !HasFailure(); ++frame) {
      SCOPED_TRACE(testing::Message() << "clip " << clip.name << ", frame " << frame);
      const float time =
          clip.duration * static_cast<float>(frame) / static_cast<float>(GetParam().frames + 1);
      for (int step = 2; step > 0; --step) {
        actor.move(&clip, std::max(time - static_cast<float>(step) / 60, 0.0f));
        actor.track();
      }
      actor.move(&clip, time);
      actor.track();
      contacts += actor.check();
    }
  EXPECT_GE(contacts, GetParam().least_all);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, SelfCollideOfModels,
    testing::Values(Case{"barbarian.glb", 2, 1}, Case{"cesium_man.glb", 5, 1},
                    Case{"cyber_character.glb", 2, 1}, Case{"cyber_enemy_large.glb", 2, 1},
                    Case{"fox_khronos.glb", 3, 1}, Case{"fox_m2m.glb", 2, 1},
                    Case{"frog.glb", 2, 1}, Case{"human.glb", 1, 1}, Case{"human_8inf.glb", 1, 1},
                    Case{"human_hi.glb", 1, 1, 3}, Case{"kaiju.glb", 2, 1},
                    Case{"knight.glb", 2, 1}, Case{"mannequin.glb", 1, 1},
                    Case{"mech_george.glb", 2, 1}, Case{"robot_expressive.glb", 2, 1},
                    Case{"simple_skin.gltf", 3, 0}, Case{"sintel.glb", 1, 1},
                    Case{"spider.glb", 2, 1}),
    kStemOfModel);

// Self-contacts of generated characters, whose bits are the same everywhere. A hash here changes
// only if the characters, the definition of a posed vertex, or that of self-contacts change.

struct Golden {
  const char* name;
  Result<asset::Asset> (*make)();
  std::size_t contacts;
  std::uint64_t hash;
};

class SelfGolden : public testing::TestWithParam<Golden> {};

/// In every other frame, each joint has the matrix of another joint, and morph targets have large
/// weights, so that the character is turned inside out.
TEST_P(SelfGolden, IsTheSameOnEveryTarget) {
  Result<asset::Asset> asset = GetParam().make();
  ASSERT_TRUE(asset) << asset.error().message;
  AnimatedCharacter character(*std::move(asset));
  Pose& pose = character.pose;
  const SelfFilter filter = *build_self_filter(pose.model());
  EXPECT_LE(filter.memory_bytes(), 40 * pose.model().triangle_count());
  on_each_instruction_set([&](InstructionSet) {
    Scratch scratch;
    std::vector<Contact> contacts;
    for (int frame = 0; frame < 8; ++frame) {
      const asset::Clip* clip = character.first_clip();
      std::vector<Matrix4> palette =
          character.palette(clip, clip->duration * static_cast<float>(frame) / 8);
      if (frame % 2) std::reverse(palette.begin(), palette.end());
      ASSERT_TRUE(pose.set_palette(palette));
      ASSERT_TRUE(pose.set_morph_weights(
          std::vector<float>(character.asset.morph_targets.size(), frame % 2 ? 20.0f : 0.5f)));
      self_collide(pose, filter, scratch, contacts);
    }
    EXPECT_EQ(contacts.size(), GetParam().contacts);
    detail::Fnv1a64 hash;
    for (const Contact& contact : contacts) {
      hash.add_u32(contact.triangle_a);
      hash.add_u32(contact.triangle_b);
    }
    EXPECT_EQ(hash.value(), GetParam().hash);
  });
}

INSTANTIATE_TEST_SUITE_P(
    Generated, SelfGolden,
    testing::Values(Golden{"dwarf", [] { return scenes::make_creature(scenes::kDwarf); }, 1277,
                           0xcd0e41959d4fcb06},
                    Golden{"man", [] { return scenes::make_creature(scenes::kMan); }, 1479,
                           0x1451944572a9f19a},
                    Golden{"face", [] { return scenes::make_face(); }, 3501, 0xdc69738ee9fcf7a3}),
    [](const auto& param_info) { return param_info.param.name; });

}  // namespace
}  // namespace pelt::test
