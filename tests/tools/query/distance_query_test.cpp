#include "tools/pelt/query/distance_query.hpp"

#include "support/contains.hpp"
#include "tools/pelt/query/pair_list.hpp"
#include "tools/scene/walkers.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

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
  Asked(const scenes::Scene& scene, std::span<const scene::Collider> colliders, double within,
        std::size_t most_hints = DistanceQuery::kMostHints)
      : staged(scene, colliders),
        poses(colliders),
        query(staged, {scene::Granularity::instance, within}, DistanceQuery::Lists::all,
              most_hints) {}

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
  const auto colliders = test::colliders_of(scene);
  constexpr double kWithin = 0.75;
  Asked all(scene, colliders, DistanceSettings().within), near(scene, colliders, kWithin);
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

TEST(DistanceQuery, QueriesOnlyPairsThatAreNear) {
  scenes::Scene scene = creatures(2000);
  for (std::uint32_t i = 0; i < 2000; ++i)
    scene.instances[i].translation = {5.0 * (i % 50), 0, 5.0 * (i / 50)};
  scene.instances[1].translation = scene.instances[0].translation;
  const auto colliders = test::colliders_of(scene);
  Asked near(scene, colliders, 0.1);
  EXPECT_EQ(near.pairs_of(0).size(), 1u);
  EXPECT_EQ(near.least().size(), 1u);
  EXPECT_GT(near.work.node_pairs, 0u);
  EXPECT_LT(near.work.node_pairs, 2000u);  // of 1,999,000 pairs
}

/// Instances that walk away from each other or towards each other.
scenes::Scene walkers(std::uint32_t count) {
  scenes::Scene scene = creatures(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    scene.instances[i].translation = {2.0 * (i % 8), 0, 2.0 * (i / 8)};
    scene.instances[i].velocity = {i % 2 == 0 ? 0.5 : -0.5, 0, 0};
  }
  return scene;
}

TEST(DistanceQuery, AnswersDoNotDependOnTheNumberOfPairsInMemory) {
  const scenes::Scene scene = walkers(50);
  const auto colliders = test::colliders_of(scene);
  const double within = DistanceSettings().within;
  Asked in_memory(scene, colliders, within), in_file(scene, colliders, within, 8);
  for (const std::uint32_t frame : {0u, 20u, 40u}) {
    const json pairs = in_memory.pairs_of(frame);
    EXPECT_EQ(pairs.size(), 1225u);  // more than one block of the file
    EXPECT_EQ(in_file.pairs_of(frame), pairs) << "frame " << frame;
  }
  const json least = in_memory.least();
  EXPECT_EQ(in_file.least(), least);
  std::set<int> frames;
  for (const json& pair : least) frames.insert(pair["frame"].get<int>());
  EXPECT_GT(frames.size(), 1u) << "a scene worth testing";
  EXPECT_TRUE(in_file.query.status());
}

TEST(DistanceQuery, StoresPairsThatExceedMemoryInAFile) {
  const scenes::Scene scene = walkers(50);
  const auto colliders = test::colliders_of(scene);
  ASSERT_EQ(setenv("TMPDIR", "/nowhere/at all", 1), 0);
  Asked in_memory(scene, colliders, DistanceSettings().within);
  in_memory.pairs_of(0);
  EXPECT_TRUE(in_memory.query.status());
  Asked in_file(scene, colliders, DistanceSettings().within, 8);
  in_file.pairs_of(0);
  unsetenv("TMPDIR");
  const auto status = in_file.query.status();
  ASSERT_FALSE(status);
  EXPECT_TRUE(test::contains(status.error().message,
                             "/nowhere/at all: cannot hold a temporary file: No such"));
}

PairDistance pair_at(std::uint32_t a, std::uint32_t b, double distance, std::uint32_t frame) {
  PairDistance pair = {.a = a, .b = b};
  pair.distance.distance = distance;
  pair.frame = frame;
  return pair;
}

/// distance, a, b, frame
using Row = std::tuple<double, std::uint32_t, std::uint32_t, std::uint32_t>;

std::vector<Row> rows_of(std::span<const PairDistance> pairs) {
  std::vector<Row> rows;
  for (const PairDistance& pair : pairs)
    rows.push_back({pair.distance.distance, pair.a, pair.b, pair.frame});
  return rows;
}

TEST(LeastDistances, AreThoseOfAllPairsWhateverTheirOrder) {
  const std::uint32_t seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr std::size_t kMax = 10;
  LeastDistances least(kMax), of_frame(kMax);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Row> all;
  std::size_t equal = 0;
  for (std::uint32_t frame = 0; frame < 30; ++frame) {
    of_frame.clear();
    for (std::uint32_t a = 0; a < 12; ++a)
      for (std::uint32_t b = a + 1; b < 12; ++b) {
        const double distance = static_cast<double>(random() % 200);  // many are equal
        of_frame.add(pair_at(a, b, distance, frame));
        const auto [known, is_new] = all.try_emplace({a, b}, distance, a, b, frame);
        equal += !is_new && distance == std::get<0>(known->second);
        if (distance < std::get<0>(known->second)) known->second = {distance, a, b, frame};
      }
    for (const PairDistance& pair : of_frame.pairs()) least.add(pair);
  }
  std::vector<Row> expected;
  for (const auto& [pair, row] : all) expected.push_back(row);
  std::sort(expected.begin(), expected.end());
  expected.resize(kMax);
  EXPECT_EQ(rows_of(least.pairs()), expected);
  EXPECT_GT(equal, 0u);
  EXPECT_TRUE(of_frame.has_left_out());
}

TEST(LeastDistances, TellWhetherAPairWasLeftOut) {
  LeastDistances least(2);
  for (const double distance : {3.0, 1.0, 2.0}) {
    least.add(pair_at(0, 1, distance, 0));
    least.add(pair_at(0, 2, distance, 0));
    EXPECT_FALSE(least.has_left_out());
  }
  LeastDistances nearer = least;
  least.add(pair_at(1, 2, 9, 0));  // is left out
  EXPECT_TRUE(least.has_left_out());
  nearer.add(pair_at(1, 2, 0, 0));  // replaces another one
  EXPECT_TRUE(nearer.has_left_out());
}

}  // namespace
}  // namespace pelt::tools::query
