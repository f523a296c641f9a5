#include "asset/clip_reader.hpp"

#include "asset/clip.hpp"
#include "support/gltf_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

json& sampler(GltfBuilder& builder) { return builder.document["animations"][0]["samplers"][0]; }
json& channel(GltfBuilder& builder) { return builder.document["animations"][0]["channels"][0]; }

TEST(Clips, HaveTheirKeys) {
  const Asset asset = test::paper_strip().read();
  ASSERT_EQ(asset.clips.size(), 1u);
  const Clip& clip = asset.clips[0];
  EXPECT_EQ(clip.name, "bend");
  EXPECT_EQ(clip.duration, 1);
  ASSERT_EQ(clip.channels.size(), 1u);
  const Channel& bend = clip.channels[0];
  EXPECT_EQ(asset.nodes[bend.node].name, "upper");
  EXPECT_EQ(bend.path, Path::rotation);
  EXPECT_EQ(bend.interpolation, Interpolation::linear);
  EXPECT_EQ(bend.times, (std::vector<float>{0, 1}));
  EXPECT_EQ(bend.values, (std::vector<float>{0, 0, 0, 1, 0, 0, 0.6f, 0.8f}));
}

TEST(Clips, HaveStepsAndSplines) {
  GltfBuilder builder = test::paper_strip();
  sampler(builder)["interpolation"] = "STEP";
  EXPECT_EQ(builder.load()->clips[0].channels[0].interpolation, Interpolation::step);
  sampler(builder)["interpolation"] = "CUBICSPLINE";
  EXPECT_TRUE(refused(builder.load(), {"animation 0 \"bend\"", "node 2 \"upper\"", "accessor 6",
                                       "has 2 elements, must have 6"}));
  const std::vector<float> spline = {9, 9, 9, 9, 0, 0, 0, 1, 8, 8, 8, 8,
                                     7, 7, 7, 7, 0, 0, 1, 0, 6, 6, 6, 6};
  sampler(builder)["output"] = builder.add_accessor(spline, "VEC4");
  const Asset asset = builder.read();
  EXPECT_EQ(asset.clips[0].channels[0].interpolation, Interpolation::cubic_spline);
  EXPECT_EQ(asset.clips[0].channels[0].values, spline);
}

TEST(Clips, MoveAndScaleNodes) {
  GltfBuilder builder = test::paper_strip();
  sampler(builder)["output"] = builder.add_accessor(std::vector<float>{1, 2, 3, 4, 5, 6}, "VEC3");
  for (const auto& [name, path] :
       {std::pair{"translation", Path::translation}, std::pair{"scale", Path::scale}}) {
    channel(builder)["target"]["path"] = name;
    const Asset asset = builder.read();
    EXPECT_EQ(asset.clips[0].channels[0].path, path);
    EXPECT_EQ(asset.clips[0].channels[0].values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  }
}

TEST(Clips, ReadQuantisedRotations) {
  GltfBuilder builder = test::paper_strip();
  const std::vector<std::int8_t> bytes = {0, 0, 0, 127, 0, 0, 76, 102};
  sampler(builder)["output"] = builder.add_accessor(bytes, "VEC4", true);
  const Asset asset = builder.read();
  const std::vector<float>& values = asset.clips[0].channels[0].values;
  EXPECT_EQ(values[3], 1);
  EXPECT_NEAR(values[6], 0.6f, 0.01f);
  EXPECT_NEAR(values[6] * values[6] + values[7] * values[7], 1, 1e-6f);
  channel(builder)["target"]["path"] = "translation";
  EXPECT_FALSE(builder.load());
}

TEST(Clips, MayBeUnnamedEmptyOrWithoutLength) {
  GltfBuilder builder = test::paper_strip();
  builder.document["animations"][0].erase("name");
  builder.accessor(5)["count"] = 1;
  builder.accessor(6)["count"] = 1;
  builder.add("animations", {{"name", "empty"}});
  const Asset asset = builder.read();
  EXPECT_EQ(asset.find_clip(""), &asset.clips[0]);
  EXPECT_EQ(asset.clips[0].duration, 0);
  EXPECT_EQ(asset.clips[0].channels.size(), 1u);
  EXPECT_EQ(asset.find_clip("empty"), &asset.clips[1]);
  EXPECT_TRUE(asset.clips[1].channels.empty());
}

TEST(Clips, SkipWeightsWithoutMorphTargetsButCountTheirDuration) {
  GltfBuilder builder = test::paper_strip();
  channel(builder)["target"]["path"] = "weights";
  const Asset asset = builder.read();
  EXPECT_TRUE(asset.clips[0].channels.empty());
  EXPECT_EQ(asset.clips[0].duration, 1);
  ASSERT_EQ(asset.warnings.size(), 1u);
  EXPECT_NE(asset.warnings[0].find("1 animation channels are ignored"), std::string::npos);
}

/// The strip with two morph targets and weights of three keys, at 0, 1 and 2 seconds.
GltfBuilder morphing_strip(const char* interpolation, const std::vector<float>& values) {
  GltfBuilder builder = test::paper_strip();
  builder.primitive()["targets"] = {{{"POSITION", 1}}, {{"POSITION", 1}}};
  const std::size_t times = builder.add_accessor(std::vector<float>{0, 1, 2}, "SCALAR");
  const std::size_t keys = builder.add_accessor(values, "SCALAR");
  test::json& animation = builder.document["animations"][0];
  animation["samplers"].push_back(
      {{"input", times}, {"output", keys}, {"interpolation", interpolation}});
  const std::size_t sampler = animation["samplers"].size() - 1;
  animation["channels"].push_back(
      {{"sampler", sampler}, {"target", {{"node", 0}, {"path", "weights"}}}});
  return builder;
}

std::vector<float> weights_at(const Asset& asset, float seconds) {
  std::vector<float> weights(asset.morph_targets.size());
  sample_morph_weights(asset, &asset.clips[0], seconds, weights);
  return weights;
}

TEST(Clips, PlayMorphWeights) {
  const Asset asset = morphing_strip("LINEAR", {0, 1, 0.5, 3, 1, 1}).read();
  EXPECT_TRUE(asset.warnings.empty());
  EXPECT_EQ(weights_at(asset, -1), (std::vector<float>{0, 1}));
  EXPECT_EQ(weights_at(asset, 0.5f), (std::vector<float>{0.25f, 2}));
  EXPECT_EQ(weights_at(asset, 1), (std::vector<float>{0.5f, 3}));
  EXPECT_EQ(weights_at(asset, 1.75f), (std::vector<float>{0.875f, 1.5f}));
  EXPECT_EQ(weights_at(asset, 9), (std::vector<float>{1, 1}));
}

TEST(Clips, PlayMorphWeightsInSteps) {
  const Asset asset = morphing_strip("STEP", {0, 1, 0.5, 3, 1, 1}).read();
  EXPECT_EQ(weights_at(asset, 0.99f), (std::vector<float>{0, 1}));
  EXPECT_EQ(weights_at(asset, 1.5f), (std::vector<float>{0.5f, 3}));
}

/// With tangents of zero the curve is 3 t^2 - 2 t^3, and a tangent of 1 adds t^3 - 2 t^2 + t.
TEST(Clips, PlayMorphWeightsAlongSplines) {
  const Asset asset =
      morphing_strip("CUBICSPLINE", {9, 9, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 9, 9}).read();
  EXPECT_EQ(weights_at(asset, 0.25f)[0], 0.15625f);
  EXPECT_EQ(weights_at(asset, 0.25f)[1], 1.140625f);
  EXPECT_EQ(weights_at(asset, 2), (std::vector<float>{1, 1}));
}

TEST(Clips, RefuseWeightsThatAreNotOneForEachTarget) {
  EXPECT_TRUE(refused(morphing_strip("LINEAR", {0, 1, 0.5}).load(),
                      {"node 0 \"paper\"", "has 3 elements, must have 6"}));
}

TEST(Clips, PassOverChannelsWithoutANode) {
  GltfBuilder builder = test::paper_strip();
  channel(builder)["target"].erase("node");
  EXPECT_TRUE(builder.load()->clips[0].channels.empty());
}

TEST(Clips, RefuseTimesThatDoNotAscend) {
  const std::pair<float, const char*> kCases[] = {
      {0, "key 1 is not later"},
      {-1, "key 1 is not later"},
      {std::numeric_limits<float>::quiet_NaN(), "element 1 is NaN"}};
  for (const auto& c : kCases) {
    GltfBuilder builder = test::paper_strip();
    builder.set_value<float>(5, 1, c.first);
    EXPECT_TRUE(refused(builder.load(), {"animation 0 \"bend\"", "accessor 5", c.second}));
  }
  GltfBuilder builder = test::paper_strip();
  builder.set_value<float>(5, 0, -1);
  EXPECT_TRUE(refused(builder.load(), {"accessor 5", "the first time is negative"}));
}

TEST(Clips, RefuseSamplersWithoutKeys) {
  GltfBuilder builder = test::paper_strip();
  builder.accessor(5)["count"] = 0;
  EXPECT_TRUE(refused(builder.load(), {"accessor 5", "is empty"}));
}

TEST(Clips, RefuseAnotherNumberOfValues) {
  GltfBuilder builder = test::paper_strip();
  builder.accessor(6)["count"] = 1;
  EXPECT_TRUE(refused(builder.load(), {"accessor 6", "has 1 elements, must have 2"}));
}

TEST(Clips, RefuseRotationsThatAreNone) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<float>(6, 7, 0);
  EXPECT_TRUE(refused(builder.load(), {"accessor 6", "key 1 is not a unit quaternion"}));
}

TEST(Clips, RefuseTwoChannelsForOneProperty) {
  GltfBuilder builder = test::paper_strip();
  builder.document["animations"][0]["channels"].push_back(json(channel(builder)));
  EXPECT_TRUE(refused(builder.load(), {"node 2 \"upper\"", "two channels"}));
}

TEST(Clips, RefuseToMoveANodeThatHasAMatrix) {
  GltfBuilder builder = test::paper_strip();
  builder.document["nodes"][2]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_TRUE(refused(builder.load(), {"animation 0 \"bend\"", "node 2 \"upper\"", "matrix"}));
}

TEST(Clips, RefuseKeysOutOfProportion) {
  constexpr std::size_t kKeys = 5000, kChannels = 500;
  GltfBuilder builder = test::paper_strip();
  std::vector<float> times(kKeys), values(4 * kKeys);
  for (std::size_t i = 0; i < kKeys; ++i) {
    times[i] = static_cast<float>(i);
    values[4 * i + 3] = 1;
  }
  sampler(builder)["input"] = builder.add_accessor(times, "SCALAR");
  sampler(builder)["output"] = builder.add_accessor(values, "VEC4");
  json channels = json::array(), nodes = builder.document["nodes"];
  for (std::size_t i = 0; i < kChannels; ++i) {
    channels.push_back(
        {{"sampler", 0}, {"target", {{"node", nodes.size()}, {"path", "rotation"}}}});
    nodes.push_back(json::object());
  }
  for (int i = 0; i < 3; ++i) {
    builder.add("animations", {{"channels", channels},
                               {"samplers", builder.document["animations"][0]["samplers"]}});
  }
  builder.document["nodes"] = nodes;
  EXPECT_TRUE(refused(builder.load(), {"accessor ", "keys", "out of proportion"}));
}

Channel translation_channel(Interpolation interpolation, std::vector<float> times,
                            std::vector<float> values) {
  return {0, Path::translation, interpolation, std::move(times), std::move(values)};
}

TEST(Channel, LinearInterpolatesAndClamps) {
  const Channel channel =
      translation_channel(Interpolation::linear, {1, 2, 4}, {0, 0, 0, 1, 10, -1, 3, 20, -5});
  const std::array<double, 4> middle = sample_channel(channel, 3);
  EXPECT_EQ(middle[0], 2);
  EXPECT_EQ(middle[1], 15);
  EXPECT_EQ(middle[2], -3);
  EXPECT_EQ(sample_channel(channel, 2)[1], 10);
  EXPECT_EQ(sample_channel(channel, 0)[0], 0);
  EXPECT_EQ(sample_channel(channel, -7)[1], 0);
  EXPECT_EQ(sample_channel(channel, 99)[1], 20);
  EXPECT_EQ(sample_channel(channel, std::numeric_limits<float>::infinity())[1], 20);
  EXPECT_EQ(sample_channel(channel, std::numeric_limits<float>::quiet_NaN())[1], 0);
}

TEST(Channel, StepReturnsTheValueOfTheLastKey) {
  const Channel channel = translation_channel(Interpolation::step, {0, 1}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(sample_channel(channel, 0.999f)[0], 1);
  EXPECT_EQ(sample_channel(channel, 1)[0], 4);
}

TEST(Channel, SingleKeyAppliesAtAllTimes) {
  for (Interpolation interpolation : {Interpolation::step, Interpolation::linear}) {
    const Channel channel = translation_channel(interpolation, {0}, {7, 8, 9});
    for (float seconds : {-1.0f, 0.0f, 1.0f}) EXPECT_EQ(sample_channel(channel, seconds)[2], 9);
  }
  const Channel cubic =
      translation_channel(Interpolation::cubic_spline, {0}, {1, 1, 1, 7, 8, 9, 2, 2, 2});
  for (float seconds : {-1.0f, 0.0f, 1.0f}) EXPECT_EQ(sample_channel(cubic, seconds)[1], 8);
}

// A cubic is its own Hermite spline: sampled values and slopes of t^3 - 2 t^2 + 3 reproduce it. The
// intervals do not have length 1, so tangents must be scaled by the length.
TEST(Channel, CubicSplineReproducesACubic) {
  const auto value = [](double t) { return t * t * t - 2 * t * t + 3; };
  const auto slope = [](double t) { return 3 * t * t - 4 * t; };
  Channel channel = translation_channel(Interpolation::cubic_spline, {0, 0.5f, 2.5f}, {});
  for (float t : channel.times) {
    for (double number : {slope(t), value(t), slope(t)}) {
      channel.values.insert(channel.values.end(), 3, static_cast<float>(number));
    }
  }
  for (float t = 0; t <= 2.5f; t += 0.0625f) {
    EXPECT_NEAR(sample_channel(channel, t)[1], value(t), 1e-12) << t;
  }
}

TEST(Channel, CubicSplineRotationIsNormalised) {
  const float half = std::sqrt(0.5f);
  const Channel channel = {
      0, Path::rotation, Interpolation::cubic_spline, {0, 1}, {0,    0,    0, 0, 0, 0,
                                                               0,    1,    0, 0, 0, 0,  //
                                                               0,    0,    0, 0, 0, 0,
                                                               half, half, 0, 0, 0, 0}};
  const std::array<double, 4> q = sample_channel(channel, 0.5f);
  EXPECT_NEAR(q[2] * q[2] + q[3] * q[3], 1, 1e-15);
  EXPECT_NEAR(q[2], std::sin(3.14159265358979 / 8), 1e-7);
}

TEST(Channel, LinearRotationTakesTheShorterWay) {
  const float half = std::sqrt(0.5f);
  const Channel channel = {
      0, Path::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half}};
  const std::array<double, 4> q = sample_channel(channel, 1.0f / 3);
  EXPECT_NEAR(q[2], std::sin(3.14159265358979 / 12), 1e-7);
  EXPECT_NEAR(q[3], std::cos(3.14159265358979 / 12), 1e-7);
}

}  // namespace
}  // namespace pelt::asset
