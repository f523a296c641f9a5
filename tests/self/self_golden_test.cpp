/// Self-contacts of generated characters, whose bits are the same everywhere. A hash here changes
/// only if the characters, the definition of a posed vertex, or that of self-contacts change.

#include <pelt/self.hpp>

#include "base/hash.hpp"
#include "scenes/creature.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {
namespace {

struct Golden {
  const char* name;
  Result<asset::Asset> (*make)();
  std::size_t contacts;
  std::uint64_t hash;
};

class SelfGolden : public testing::TestWithParam<Golden> {};

/// The palette of a frame. In every other frame, each joint has the matrix of another joint, and
/// morph targets have large weights, so that the character is turned inside out.
std::vector<Matrix4> palette_of(const asset::Asset& asset, int frame) {
  asset::SampleScratch samples;
  std::vector<Matrix4> palette(asset.joints.size());
  const asset::Clip& clip = asset.clips[0];
  sample_palette(asset, &clip, clip.duration * static_cast<float>(frame) / 8, {}, samples, palette);
  if (frame % 2) std::reverse(palette.begin(), palette.end());
  return palette;
}

TEST_P(SelfGolden, IsTheSameOnEveryTarget) {
  const Result<asset::Asset> asset = GetParam().make();
  ASSERT_TRUE(asset) << asset.error().message;
  Pose pose(*build_model(asset->mesh()));
  const SelfFilter filter = *build_self_filter(pose.model());
  EXPECT_LE(filter.memory_bytes(), 40 * asset->triangles.size());
  on_each_instruction_set([&](InstructionSet) {
    Scratch scratch;
    std::vector<Contact> contacts;
    for (int frame = 0; frame < 8; ++frame) {
      ASSERT_TRUE(pose.set_palette(palette_of(*asset, frame)));
      ASSERT_TRUE(pose.set_morph_weights(
          std::vector<float>(asset->morph_targets.size(), frame % 2 ? 20.0f : 0.5f)));
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
