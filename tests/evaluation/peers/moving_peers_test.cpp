/// FCL's continuous collision detection does the work that it is measured for, and its misses are
/// counted.

#include "evaluation/methods/moving_methods.hpp"
#include "evaluation/peers/moving_peer_figures.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace pelt::peers {
namespace {

MovingContact contact(std::uint32_t a, std::uint32_t b, float time, bool at_start = false) {
  return {{a, b}, time, at_start, {}, {}};
}

TEST(MovingCompare, CountsEachKindOfDifference) {
  const std::vector<MovingContact> exact = {contact(0, 1, 0, true), contact(0, 2, 0, true),
                                            contact(1, 0, 0.5f),    contact(1, 1, 0.5f),
                                            contact(1, 2, 0.5f),    contact(3, 3, 0.25f)};
  EXPECT_EQ(compare_moving(exact, exact), MovingDifference{});
  const std::vector<MovingContact> answer = {contact(0, 2, 0.75f), contact(1, 0, 0.49f),
                                             contact(1, 1, 0.51f), contact(1, 2, 0.50001f),
                                             contact(2, 2, 1)};
  EXPECT_EQ(compare_moving(answer, exact), (MovingDifference{1, 1, 1, 1, 1}));
  EXPECT_EQ(compare_moving({}, exact), (MovingDifference{2, 4, 0, 0, 0}));
}

/// Two small creatures that walk through each other.
scenes::Scene walkers() {
  scenes::Scene scene;
  scene.name = "walkers";
  Result<scenes::Character> character = scenes::generate_character({1000, 24, 1});
  EXPECT_TRUE(character);
  scene.characters.push_back(std::move(*character));
  scene.fps = 12;
  scene.frame_count = 40;
  scene.instances.resize(2);
  for (const int i : {0, 1}) {
    scene.instances[i].clip = "walk";
    scene.instances[i].translation = {0.05 * i, 0, i == 0 ? -1.4 : 1.4};
    scene.instances[i].rotation = {0, double(i), 0, double(1 - i)};
    scene.instances[i].velocity = {0, 0, i == 0 ? 0.9 : -0.9};
  }
  return scene;
}

TEST(MovingPeers, FclFindsWhatBeginsDuringAStepInMillimetres) {
  const scenes::Scene scene = walkers();
  const auto steps = lab::choose_steps(scene, std::nullopt);
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  ASSERT_TRUE(steps && colliders);
  const auto measured = tools::measure_moving_peers({scene, *colliders, *steps}, 1);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->steps, 39u);
  EXPECT_GT(measured->steps_in_contact, 3u);
  EXPECT_GT(measured->contacts_at_start, 20u);
  EXPECT_GT(measured->contacts, measured->contacts_at_start + 100);
  std::ostringstream table;
  print_moving_peers(*measured, table);
  std::puts(table.str().c_str());
  const auto& methods = measured->methods;
  ASSERT_EQ(methods.size(), 4u);
  for (const tools::MovingPeerFigures& figures : methods) EXPECT_GT(figures.step_us, 0);
  EXPECT_EQ(methods[0].difference, MovingDifference{}) << methods[0].method;
  EXPECT_EQ(methods[1].difference, MovingDifference{}) << methods[1].method;
  const std::size_t later = measured->contacts - measured->contacts_at_start;
  const auto& [at_start, missing, extra, early, late] = methods[3].difference;
  EXPECT_EQ(methods[3].method, "fcl in 1/1000");
  EXPECT_LT(200 * (missing + extra + early + late), later);
  EXPECT_GT(at_start, 0u) << "no event begins these";
  EXPECT_LT(at_start, measured->contacts_at_start);
}

}  // namespace
}  // namespace pelt::peers
