#include "scenes/creature.hpp"

#include <pelt/pelt.hpp>

#include "base/hash.hpp"
#include "scenes/character_glb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace pelt::scenes {
namespace {

using asset::Asset;

Asset make(const FaceOptions& options) {
  Result<Asset> asset = make_face(options);
  EXPECT_TRUE(asset) << (asset ? "" : asset.error().message);
  return asset ? std::move(*asset) : Asset();
}

std::size_t displaced_by(const Asset& asset, std::size_t target) {
  return asset.morph_begin[target + 1] - asset.morph_begin[target];
}

TEST(Face, HasWhatItPromises) {
  for (const FaceOptions& options : {FaceOptions{}, FaceOptions{1000, 7}, FaceOptions{20001, 3}}) {
    SCOPED_TRACE(options.triangles);
    const Asset asset = make(options);
    EXPECT_EQ(asset.triangles.size(), options.triangles / 2 * 2);
    EXPECT_EQ(2 * asset.rest_positions.size(), asset.triangles.size() + 4) << "as of a ball";
    EXPECT_EQ(asset.joints.size(), 7u);
    ASSERT_EQ(asset.morph_targets.size(), 6u);
    EXPECT_EQ(asset.morph_targets[0].name, "jaw_open");
    for (std::size_t m = 0; m < 6; ++m) {
      EXPECT_GT(displaced_by(asset, m), 10u) << asset.morph_targets[m].name;
      EXPECT_LT(displaced_by(asset, m), asset.rest_positions.size() / 2)
          << asset.morph_targets[m].name;
    }
    const SkinnedModel model = *build_model(asset.mesh());
    EXPECT_EQ(model.report().renormalised_vertices, 0u);
  }
}

TEST(Face, StandsOnTheGround) {
  const Asset asset = make({});
  float low = 1, high = 0;
  for (const Vec3& p : asset.rest_positions) low = std::min(low, p.y), high = std::max(high, p.y);
  EXPECT_NEAR(low, 0, 0.01);
  EXPECT_GT(high, 0.3);
  EXPECT_LT(high, 0.8);
}

TEST(Face, RefusesOptionsOutOfRange) {
  const Result<Asset> few = make_face({999, 1});
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().message, "face: triangles is 999, expected 1000 to 200000");
  EXPECT_FALSE(make_face({200001, 1}));
}

/// Measures how far the tip of the jaw moves down and the corners of the mouth move up.
TEST(Face, ExpressionsMoveWhatTheyAreNamedAfter) {
  const Asset asset = make({});
  Pose pose(*build_model(asset.mesh()));
  const auto moved = [&](std::size_t target) {
    std::vector<float> weights(6);
    weights[target] = 1;
    EXPECT_TRUE(pose.set_morph_weights(weights));
    std::vector<Vec3> posed(asset.rest_positions.size());
    posed_vertices(pose, posed);
    Vec3 sum;
    for (std::size_t v = 0; v < posed.size(); ++v) {
      sum.x += posed[v].x - asset.rest_positions[v].x;
      sum.y += posed[v].y - asset.rest_positions[v].y;
    }
    return sum;
  };
  EXPECT_LT(moved(0).y, -0.1f) << "jaw_open";
  EXPECT_GT(moved(1).y, 0.1f) << "smile";
  EXPECT_LT(moved(2).y, -0.1f) << "blink_l";
  EXPECT_GT(moved(4).y, 0.1f) << "brows_up";
  EXPECT_NEAR(moved(5).x, 0, 0.2f) << "cheeks_puffed, on both sides";
}

TEST(Face, TalksWithWeightsThatComeAndGo) {
  const Asset asset = make({});
  const asset::Clip* talk = asset.find_clip("talk");
  ASSERT_NE(talk, nullptr);
  std::vector<float> weights(6), first(6), last(6);
  asset::sample_morph_weights(asset, talk, 0, first);
  asset::sample_morph_weights(asset, talk, talk->duration, last);
  EXPECT_EQ(first, last) << "a loop";
  for (std::size_t m = 0; m < 6; ++m) {
    int active = 0;
    for (int frame = 0; frame < 100; ++frame) {
      asset::sample_morph_weights(asset, talk, 0.04f * static_cast<float>(frame), weights);
      active += weights[m] != 0;
    }
    EXPECT_GT(active, 10) << asset.morph_targets[m].name;
    EXPECT_LT(active, 90) << asset.morph_targets[m].name;
  }
}

/// Hash of everything in an asset that a query can observe.
std::uint64_t hash_of(const Asset& asset) {
  detail::Fnv1a64 hash;
  const auto add = [&](float number) { hash.add_u32(std::bit_cast<std::uint32_t>(number)); };
  const auto add_all = [&](const std::vector<Vec3>& vectors) {
    for (const Vec3& v : vectors) add(v.x), add(v.y), add(v.z);
  };
  add_all(asset.rest_positions);
  for (const Triangle& t : asset.triangles)
    for (const std::uint32_t v : t) hash.add_u32(v);
  for (const std::uint16_t joint : asset.joint_indices) hash.add_u32(joint);
  for (const float weight : asset.weights) add(weight);
  for (const std::uint32_t begin : asset.morph_begin) hash.add_u32(begin);
  for (const std::uint32_t vertex : asset.morph_vertices) hash.add_u32(vertex);
  add_all(asset.morph_displacements);
  for (const asset::Joint& joint : asset.joints) {
    hash.add_u32(joint.node);
    for (const float number : joint.inverse_bind.m) add(number);
  }
  for (const asset::Node& node : asset.nodes) {
    hash.add_u32(node.parent);
    for (const float number : node.local.translation) add(number);
  }
  for (const asset::Clip& clip : asset.clips) {
    add(clip.duration);
    for (const asset::Channel& channel : clip.channels) {
      hash.add_u32(channel.node);
      hash.add_u32(static_cast<std::uint32_t>(channel.path));
      for (const float time : channel.times) add(time);
      for (const float value : channel.values) add(value);
    }
  }
  return hash.value();
}

// The bits do not depend on the compiler or the optimisation level.
TEST(Face, SameBitsEverywhere) { EXPECT_EQ(hash_of(make({})), 0xbca77aa55361213cu); }

Asset written_and_read(const Asset& asset) {
  Result<Asset> read = asset::load_gltf(character_glb(asset), {});
  EXPECT_TRUE(read) << (read ? "" : read.error().message);
  if (!read) return {};
  EXPECT_TRUE(read->warnings.empty());
  return std::move(*read);
}

TEST(CharacterGlb, IsReadAsItWas) {
  const Asset face = make({}), read = written_and_read(face);
  EXPECT_EQ(hash_of(read), hash_of(face));
  ASSERT_EQ(read.morph_targets.size(), face.morph_targets.size());
  for (std::size_t m = 0; m < face.morph_targets.size(); ++m)
    EXPECT_EQ(read.morph_targets[m].name, face.morph_targets[m].name);
  ASSERT_EQ(read.nodes.size(), face.nodes.size());
  for (std::size_t n = 0; n < face.nodes.size(); ++n)
    EXPECT_EQ(read.nodes[n].name, face.nodes[n].name);
}

/// The order of its nodes changes, the order of its joints does not.
TEST(CharacterGlb, PlaysAsItDid) {
  const Asset creature = *make_creature({1000, 24, 1}), read = written_and_read(creature);
  ASSERT_EQ(read.clips.size(), 2u);
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(24), palette_of_read(24);
  for (const asset::Clip& clip : creature.clips)
    for (const float share : {0.0f, 0.3f, 0.9f}) {
      const float seconds = share * clip.duration;
      asset::sample_palette(creature, &clip, seconds, {}, scratch, palette);
      asset::sample_palette(read, read.find_clip(clip.name), seconds, {}, scratch, palette_of_read);
      EXPECT_EQ(palette, palette_of_read) << clip.name << " at " << seconds;
    }
}

}  // namespace
}  // namespace pelt::scenes
