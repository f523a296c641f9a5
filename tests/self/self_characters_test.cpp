/// Real characters in all their clips, compared with brute force over the posed vertices.

#include <pelt/asset.hpp>
#include <pelt/self.hpp>

#include "self_brute_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <span>
#include <string>

namespace pelt::test {
namespace {

struct Case {
  const char* model;
  int frames;             ///< per clip
  std::size_t least_all;  ///< contacts in all frames, at least
  std::size_t most_clips = std::numeric_limits<std::size_t>::max();
};

/// A character in poses of its clips.
struct Actor {
  explicit Actor(const asset::Asset& file)
      : asset(file),
        surface(surface_vertices(file.mesh())),
        pose(*build_model(file.mesh(), {.off_weights = OffWeights::renormalise})),
        filter(*build_self_filter(pose.model())),
        without_neighbours(*build_self_filter(pose.model(), {.rings = 1})),
        tracker(filter) {}

  void move(const asset::Clip* clip, float seconds) {
    std::vector<Matrix4> palette(asset.joints.size());
    std::vector<float> weights(asset.morph_targets.size());
    sample_palette(asset, clip, seconds, {}, samples, palette);
    sample_morph_weights(asset, clip, seconds, weights);
    for (std::size_t m = 0; m < weights.size(); m += 3) weights[m] += 0.5f;
    ASSERT_TRUE(pose.set_palette(palette));
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

  const asset::Asset& asset;
  std::vector<std::uint32_t> surface;
  Pose pose;
  SelfFilter filter, without_neighbours;
  SelfTracker tracker;
  Scratch scratch;
  asset::SampleScratch samples;
};

class SelfCollideOfModels : public testing::TestWithParam<Case> {};

TEST_P(SelfCollideOfModels, EqualsBruteForce) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam().model;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Actor actor(*asset);
  EXPECT_LE(actor.filter.memory_bytes(), 40 * asset->triangles.size() + 4096);
  actor.move(nullptr, 0);
  std::size_t contacts = actor.check();
  const std::size_t clips = std::min(asset->clips.size(), GetParam().most_clips);
  for (const asset::Clip& clip : std::span(asset->clips).first(clips))
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
    [](const auto& param_info) {
      std::string name = param_info.param.model;
      return name.substr(0, name.find('.'));
    });

}  // namespace
}  // namespace pelt::test
