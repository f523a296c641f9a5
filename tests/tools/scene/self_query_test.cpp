#include "tools/pelt/scene/scene_query.hpp"

#include "scenes/scene.hpp"
#include "tools/pelt/scene/colliders.hpp"
#include "tools/test_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {
namespace {

using tools::scene::FrameContacts;

constexpr const char* kFiveCurls = R"({
  "models": {"a": "curl.glb"},
  "frames": {"count": 3, "fps": 50},
  "instances": [
    {"model": "a", "clip": "sway", "start": 0.4},
    {"model": "a", "clip": "sway", "start": 0.45, "translation": [0.1, 0, 0]},
    {"model": "a", "clip": "sway", "start": 0.5, "translation": [0.2, 0, 0]},
    {"model": "a", "clip": "sway", "start": 0.42, "translation": [0.3, 0, 0]},
    {"model": "a", "clip": "sway", "start": 0.55, "translation": [9, 0, 0]}]})";

/// The contacts of all frames with this number of threads.
std::vector<FrameContacts> self_contacts_with(std::uint32_t threads, tools::scene::Granularity by,
                                              LeftOut& left_out, QueryStats& work) {
  const TestFolder folder;
  write_bytes(folder / "curl.glb", build_curl().glb());
  write_text(folder / "scene.json", kFiveCurls);
  const auto scene = *scenes::load_scene(folder / "scene.json");
  const auto colliders = *tools::scene::make_colliders(scene, by, {});
  const tools::scene::StagedScene staged(scene, colliders);
  tools::scene::SelfRules rules;
  rules.rings = 1;
  rules.drops_near_joints = false;
  auto filters = tools::scene::make_self_filters(staged, rules, {0, 3, 1});
  EXPECT_TRUE(filters) << filters.error().message;
  auto query =
      tools::scene::SceneQuery::as_crowd(colliders, threads, {.filters = std::move(*filters)});
  std::vector<FrameContacts> frames;
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  for (std::uint32_t frame = 0; frame < 3; ++frame) {
    tools::scene::sample_palettes(scene, frame, scratch, palettes);
    EXPECT_TRUE(query.set_palettes(palettes));
    frames.emplace_back();
    query.collide({}, frames.back());
    left_out += query.left_out();
  }
  work = query.work();
  return frames;
}

bool are_same_contacts(const FrameContacts& x, const FrameContacts& y) {
  const auto same = [](const FrameContacts::Pair& p, const FrameContacts::Pair& q) {
    return p.a == q.a && p.b == q.b && p.begin == q.begin && p.end == q.end;
  };
  return x.contacts == y.contacts &&
         std::equal(x.pairs.begin(), x.pairs.end(), y.pairs.begin(), y.pairs.end(), same);
}

TEST(SelfQuery, AnswersTheSameOnAnyNumberOfThreads) {
  for (const auto by : {tools::scene::Granularity::instance, tools::scene::Granularity::part}) {
    LeftOut expected_out;
    QueryStats expected_work;
    const auto expected = self_contacts_with(1, by, expected_out, expected_work);
    std::size_t selves = 0;
    for (const FrameContacts& frame : expected)
      for (const FrameContacts::Pair& pair : frame.pairs) selves += pair.a == pair.b;
    EXPECT_GT(selves, 5u);
    EXPECT_GT(expected_out.total(), 10u);
    for (const std::uint32_t threads : {2u, 3u, 16u}) {
      LeftOut left_out;
      QueryStats work;
      const auto found = self_contacts_with(threads, by, left_out, work);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t f = 0; f < found.size(); ++f)
        EXPECT_TRUE(are_same_contacts(found[f], expected[f])) << threads << " threads, frame " << f;
      EXPECT_EQ(left_out.total(), expected_out.total());
      EXPECT_EQ(work.triangle_pairs, expected_work.triangle_pairs);
      EXPECT_EQ(work.node_pairs, expected_work.node_pairs);
    }
  }
}

}  // namespace
}  // namespace pelt::test
