#include "tools/pelt/query/distance_query.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <sstream>

namespace pelt::tools::query {
namespace {

using nlohmann::json;

scenes::Scene creatures(std::uint32_t count) {
  scenes::Scene scene;
  scene.characters.push_back(*scenes::generate_character(scenes::CreatureOptions{1000, 24, 1}));
  scene.instances.resize(count);
  for (scenes::Instance& instance : scene.instances) instance.clip = "walk";
  return scene;
}

template <typename Write>
json written(const Write& write) {
  std::ostringstream text;
  scene::JsonLine line(text);
  write(line);
  line.end();
  return json::parse(text.str());
}

/// A query of a scene, frame by frame.
struct Asked {
  Asked(const scenes::Scene& scene, std::span<const scene::Collider> colliders, double within)
      : staged(scene, colliders),
        poses(colliders),
        query(staged, {scene::Granularity::instance, within}, DistanceQuery::Lists::all) {}

  json pairs_of(std::uint32_t frame) {
    scene::sample_palettes(staged.scene, frame, scratch, palettes);
    EXPECT_TRUE(poses.set_palettes(palettes));
    work = query.ask(poses.poses());
    query.keep(frame);
    return written([&](scene::JsonLine& line) { query.write_frame(line); })["pairs"];
  }

  json least() {
    return written([&](scene::JsonLine& line) { query.write_totals(line); })["least"];
  }

  scene::StagedScene staged;
  scene::ScenePoses poses;
  DistanceQuery query;
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  QueryStats work;
};

json within(const json& pairs, double distance) {
  json near = json::array();
  for (const json& pair : pairs)
    if (pair["distance"] <= distance) near.push_back(pair);
  return near;
}

TEST(DistanceQuery, FindsTheSamePairsWithinADistanceAsWithoutOne) {
  const std::uint32_t seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-3, 3);
  scenes::Scene scene = creatures(16);
  for (scenes::Instance& instance : scene.instances) {
    instance.translation = {place(random), place(random), place(random)};
    instance.velocity = {place(random), 0, place(random)};
  }
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  constexpr double kWithin = 0.75;
  Asked all(scene, *colliders, DistanceSettings().within), near(scene, *colliders, kWithin);
  std::size_t found = 0, left_out = 0;
  for (std::uint32_t frame = 0; frame < 60; frame += 15) {
    const json pairs = all.pairs_of(frame);
    EXPECT_EQ(pairs.size(), 16u * 15 / 2);
    const json expected = within(pairs, kWithin);
    EXPECT_EQ(near.pairs_of(frame), expected) << "frame " << frame;
    found += expected.size();
    left_out += pairs.size() - expected.size();
  }
  EXPECT_GT(found, 0u);
  EXPECT_GT(left_out, 0u);
  EXPECT_EQ(all.least().size(), 16u * 15 / 2);
  EXPECT_EQ(near.least(), within(all.least(), kWithin));
}

TEST(DistanceQuery, AsksOnlyPairsThatAreNear) {
  scenes::Scene scene = creatures(2000);
  for (std::uint32_t i = 0; i < 2000; ++i)
    scene.instances[i].translation = {5.0 * (i % 50), 0, 5.0 * (i / 50)};
  scene.instances[1].translation = scene.instances[0].translation;
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  Asked near(scene, *colliders, 0.1);
  EXPECT_EQ(near.pairs_of(0).size(), 1u);
  EXPECT_EQ(near.least().size(), 1u);
  EXPECT_GT(near.work.node_pairs, 0u);
  EXPECT_LT(near.work.node_pairs, 2000u);  // of 1,999,000 pairs
}

}  // namespace
}  // namespace pelt::tools::query
