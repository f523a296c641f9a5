#include "tools/pelt/check/tallies.hpp"

#include <pelt/self_filter.hpp>

#include "support/random.hpp"
#include "tools/scene/walkers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace pelt::tools::check {
namespace {

using test::Random;

/// Two triangles, each a part.
asset::Asset two_parts() {
  asset::Asset asset;
  asset.rest_positions.resize(6, Vec3{0, 0, 0});
  asset.triangles = {{0, 1, 2}, {3, 4, 5}};
  asset.influences_per_vertex = 1;
  asset.joint_indices.resize(6, 0);
  asset.weights.resize(6, 1);
  asset.nodes.resize(1);
  asset.joints.resize(1);
  asset.parts.resize(2);
  asset.parts[0].triangle_count = asset.parts[1].triangle_count = 1;
  asset.parts[1].first_triangle = 1;
  return asset;
}

/// `instances`: the character of each one.
scenes::Scene scene_with(const std::vector<std::uint32_t>& instances) {
  scenes::Scene scene;
  for (const char* name : {"knight", "thief"})
    scene.characters.push_back({name, name, 0, two_parts()});
  for (const std::uint32_t character : instances) {
    scene.instances.emplace_back();
    scene.instances.back().character = character;
  }
  return scene;
}

/// Pairs of triangles, each with its own probability to be in contact.
std::vector<Contact> random_contacts(Random& random) {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < 60; ++i)
    if (i < 30 || random.index(100) < 40 + i) contacts.push_back({i % 7, 10 + i});
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

void append(std::uint32_t a, std::uint32_t b, const std::vector<Contact>& contacts,
            scene::FrameContacts& found) {
  const std::size_t begin = found.contacts.size();
  found.contacts.insert(found.contacts.end(), contacts.begin(), contacts.end());
  found.pairs.push_back({a, b, begin, found.contacts.size()});
}

TEST(AlwaysTally, CountsTheContactsOfWhatContactTallyFinds) {
  Random random(2204);
  const scenes::Scene scene = scene_with({0, 1, 0});
  const auto colliders = test::colliders_of(scene);
  std::size_t rare = 0, frequent = 0;
  for (std::size_t frames = 1; frames <= 60; ++frames) {
    AlwaysTally tally({scene, colliders}, frames, 0.95);
    std::array<ContactTally, 2> expected;
    std::array<std::map<Contact, std::uint64_t>, 2> counts;
    std::uint64_t contacts = 0;
    for (std::size_t f = 0; f < frames; ++f) {
      scene::FrameContacts found;
      for (const std::uint32_t c : {0u, 1u, 2u}) {
        const std::vector<Contact> own = random_contacts(random);
        append(c, c, own, found);
        expected[c % 2].add(own);
        for (const Contact& contact : own) ++counts[c % 2][contact];
        contacts += own.size();
        if (c == 0) append(0, 1, own, found);  // contacts of two instances do not count
      }
      tally.add(found);
    }
    std::uint64_t always = 0;
    for (const std::size_t character : {0u, 1u}) {
      const std::vector<Contact> pairs = expected[character].in_share_of_poses(0.95);
      for (const Contact& pair : pairs) always += counts[character][pair];
      frequent += pairs.size();
      rare += counts[character].size() - pairs.size();
    }
    EXPECT_EQ(tally.counts().contacts, contacts) << frames;
    EXPECT_EQ(tally.counts().always, always) << frames;
  }
  EXPECT_GT(frequent, 1000u);
  EXPECT_GT(rare, 1000u);
}

TEST(AlwaysTally, CountsContactsOfTwoPartsOfOneInstance) {
  const scenes::Scene scene = scene_with({0});
  const auto parts = scene::make_colliders(scene, scene::Granularity::part, {});
  ASSERT_TRUE(parts) << parts.error().message;
  ASSERT_EQ(parts->size(), 2u);
  AlwaysTally tally({scene, *parts}, 3, 0.95);
  for (std::uint32_t f = 0; f < 3; ++f) {
    scene::FrameContacts found;
    append(0, 0, {{5, 6}}, found);
    append(0, 1, {{1, 9}, {2, 9 + f}}, found);
    tally.add(found);
  }
  EXPECT_EQ(tally.counts().contacts, 9u);
  EXPECT_EQ(tally.counts().always, 6u);
}

InsidePair contained(std::uint32_t a, std::uint32_t b, Containment containment) {
  return {.a = a, .b = b, .containment = containment};
}

TEST(InsideTally, CountsTheFramesOfEachContainedBody) {
  InsideTally tally;
  const std::vector<InsidePair> both = {contained(0, 1, Containment::a_in_b),
                                        contained(0, 2, Containment::b_in_a)};
  tally.add(3, both);
  tally.add(4, {});
  tally.add(5, std::span(both).last(1));
  tally.add(6, std::vector{contained(0, 2, Containment::a_in_b)});
  ASSERT_EQ(tally.held.size(), 3u);
  EXPECT_EQ(tally.held[0].inner, 0u);
  EXPECT_EQ(tally.held[0].outer, 1u);
  EXPECT_EQ(tally.held[0].frames, 1u);
  EXPECT_EQ(tally.held[1].inner, 2u);
  EXPECT_EQ(tally.held[1].outer, 0u);
  EXPECT_EQ(tally.held[1].frames, 2u);
  EXPECT_EQ(tally.held[1].first_frame, 3u);
  EXPECT_EQ(tally.held[2].inner, 0u);
  EXPECT_EQ(tally.held[2].first_frame, 6u);
  EXPECT_EQ(tally.frames_held, (std::vector<std::uint32_t>{3, 5, 6}));
}

TEST(InsideTally, CountsEachTakeByItself) {
  InsideTally tally;
  const std::vector<InsidePair> pair = {contained(0, 1, Containment::a_in_b)};
  tally.add(3, pair, 0);
  tally.add(4, pair, 1);
  tally.add(5, pair, 1);
  ASSERT_EQ(tally.held.size(), 2u);
  EXPECT_EQ(tally.held[0].take, 0u);
  EXPECT_EQ(tally.held[0].frames, 1u);
  EXPECT_EQ(tally.held[1].take, 1u);
  EXPECT_EQ(tally.held[1].first_frame, 4u);
  EXPECT_EQ(tally.held[1].frames, 2u);
}

/// Comparing all bodies with each other would take 10^11 steps, which is minutes.
TEST(InsideTally, CountsInTimeLinearInBodies) {
  std::vector<InsidePair> pairs;
  for (std::uint32_t b = 1; b <= 800'000; ++b)
    pairs.push_back(contained(0, b, Containment::b_in_a));
  InsideTally tally;
  tally.add(0, pairs);
  tally.add(1, pairs);
  ASSERT_EQ(tally.held.size(), pairs.size());
  EXPECT_EQ(tally.held.back().inner, 800'000u);
  EXPECT_EQ(tally.held.back().frames, 2u);
}

}  // namespace
}  // namespace pelt::tools::check
