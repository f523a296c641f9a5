/// Peers are measured beside Pelt on the same frames, and differences from brute force are counted.

#include "evaluation/peers/peer_figures.hpp"
#include "evaluation/methods/moving_methods.hpp"
#include "evaluation/peers/moving_peer_figures.hpp"
#include "evaluation/peers/peers.hpp"
#include "evaluation/two_walkers.hpp"
#include "scenes/creature.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace pelt::peers {
namespace {

using Contacts = std::vector<Contact>;

const Contacts kExact = {{1, 5}, {2, 3}, {2, 4}};

TEST(Compare, OrderMeansNothing) {
  EXPECT_EQ(compare(Contacts{{2, 4}, {1, 5}, {2, 3}}, kExact), Difference{});
  EXPECT_EQ(compare({}, {}), Difference{});
}

TEST(Compare, CountsWhatIsMissing) {
  EXPECT_EQ(compare(Contacts{{2, 3}}, kExact), (Difference{2, 0, 0}));
  EXPECT_EQ(compare({}, kExact), (Difference{3, 0, 0}));
}

TEST(Compare, CountsWhatIsTooMuch) {
  EXPECT_EQ(compare(Contacts{{1, 5}, {2, 3}, {2, 4}, {3, 2}}, kExact), (Difference{0, 1, 0}));
  EXPECT_EQ(compare(kExact, {}), (Difference{0, 3, 0}));
}

TEST(Compare, CountsRepetitionsApart) {
  EXPECT_EQ(compare(Contacts{{2, 3}, {2, 3}, {9, 9}, {9, 9}, {9, 9}}, kExact),
            (Difference{2, 1, 3}));
}

TEST(Compare, PairsHaveASide) {
  EXPECT_EQ(compare(Contacts{{5, 1}, {2, 3}, {2, 4}}, kExact), (Difference{1, 1, 0}));
}

TEST(Compare, DifferencesAdd) {
  Difference sum = {1, 2, 3};
  sum += {10, 20, 30};
  EXPECT_EQ(sum, (Difference{11, 22, 33}));
}

// FCL's continuous collision detection does the work that it is measured for, and its misses are
// counted.

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

TEST(MovingPeers, FclFindsWhatBeginsDuringAStepInMillimetres) {
  const scenes::Scene scene = test::two_walkers();
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

namespace pelt::tools {
namespace {

/// Three dwarfs: the first two intersect, the third is far away.
scenes::Scene dwarfs() {
  scenes::Scene scene;
  scene.name = "dwarfs";
  scene.frame_count = 3;
  scene.characters.push_back(*scenes::generate_character(scenes::kDwarf));
  for (const double x : {0.0, 0.3, 9.0}) {
    scenes::Instance dwarf;
    dwarf.clip = "walk";
    dwarf.translation = {x, 0, x};
    scene.instances.push_back(dwarf);
  }
  return scene;
}

ScenePeers measured() {
  const scenes::Scene scene = dwarfs();
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  EXPECT_TRUE(colliders);
  const std::vector<std::uint32_t> frames = {0, 2};
  std::size_t steps = 0;
  const auto peers = measure_peers({scene, *colliders, frames}, 1, [&] { ++steps; });
  EXPECT_TRUE(peers);
  EXPECT_EQ(steps, peer_steps(frames.size()));
  return *peers;
}

TEST(PeerFigures, HaveARowForPeltAndEachPeer) {
  const ScenePeers scene = measured();
  ASSERT_EQ(scene.methods.size(), peers::all_peers().size() + 2);
  EXPECT_EQ(scene.methods[0].method, "pelt on_demand");
  EXPECT_EQ(scene.methods[1].method, "pelt eager");
  for (std::size_t i = 0; i < peers::all_peers().size(); ++i)
    EXPECT_EQ(scene.methods[i + 2].method, peers::all_peers()[i].name);
}

TEST(PeerFigures, CountWhatDiffersFromTheExactAnswer) {
  const ScenePeers scene = measured();
  EXPECT_EQ(scene.frames, 2u);
  EXPECT_EQ(scene.frames_in_contact, 2u);
  EXPECT_GT(scene.contacts, 100u);
  EXPECT_EQ(scene.methods[0].difference, peers::Difference{});
  EXPECT_EQ(scene.methods[1].difference, peers::Difference{});
  for (std::size_t i = 0; i < peers::all_peers().size(); ++i) {
    const peers::Difference& difference = scene.methods[i + 2].difference;
    const peers::Answers answers = peers::all_peers()[i].answers;
    EXPECT_EQ(difference.missing > 0, answers == peers::Answers::fewer)
        << scene.methods[i + 2].method;
    EXPECT_LT(difference.missing, scene.contacts / 10);
    if (answers == peers::Answers::exact) {
      EXPECT_EQ(difference.extra, 0u);
    }
  }
}

TEST(PeerFigures, SplitTheTimeOfAFrame) {
  for (const PeerFigures& figures : measured().methods) {
    SCOPED_TRACE(figures.method);
    EXPECT_GT(figures.frame_us, 0);
    EXPECT_GT(figures.first_frame_us, 0);
    EXPECT_GT(figures.all_us, 0);
    EXPECT_GT(figures.first_us, 0);
    EXPECT_EQ(figures.skinning_us > 0, !figures.method.starts_with("pelt"));
    EXPECT_GE(figures.skinning_us + figures.update_us + figures.all_us, 0.999 * figures.frame_us);
  }
}

/// A creature that touches itself in some frames of its walk.
TEST(PeerFigures, CompareACharacterWithItself) {
  scenes::Scene scene = dwarfs();
  scene.characters[0] = *scenes::generate_character(scenes::kCreature);
  scene.instances.resize(1);
  scene.frame_count = 40;
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  ASSERT_TRUE(colliders);
  const std::vector<std::uint32_t> frames = {0, 8, 16, 24};
  std::size_t steps = 0;
  const auto figures = measure_peers(
      {scene, *colliders, frames}, 1, [&] { ++steps; }, Contest::self);
  ASSERT_TRUE(figures);
  EXPECT_EQ(steps, peer_steps(frames.size(), Contest::self));
  EXPECT_GT(figures->contacts, 0u);
  ASSERT_EQ(figures->methods.size(), peers::all_self_peers().size() + 2);
  EXPECT_EQ(figures->methods[0].method, "pelt self");
  for (std::size_t m = 0; m < figures->methods.size(); ++m) {
    const PeerFigures& one = figures->methods[m];
    SCOPED_TRACE(one.method);
    EXPECT_EQ(one.difference.extra + one.difference.repeated, 0u);
    if (m < 2 || peers::all_self_peers()[m - 2].answers == peers::Answers::exact) {
      EXPECT_EQ(one.difference.missing, 0u);
    }
    EXPECT_EQ(one.skinning_us > 0, m >= 2);
    EXPECT_LT(cost_over_pelt(*figures, one) * figures->methods[0].frame_us,
              one.frame_us + (m < 2 ? 1e-6 : 0));
  }
}

TEST(PeerFigures, AreWrittenAsRowsOfEqualWidth) {
  const ScenePeers scene = measured();
  std::stringstream csv, table;
  write_peers_csv(std::vector{scene, scene}, csv);
  print_peers(scene, table);
  std::size_t rows = 0, columns = 0;
  for (std::string line; std::getline(csv, line); ++rows) {
    std::size_t quotes = 0, cells = 1;
    for (const char c : line) {
      quotes += c == '"';
      cells += c == ',' && quotes % 2 == 0;
    }
    if (rows == 0) columns = cells;
    EXPECT_EQ(cells, columns) << line;
  }
  EXPECT_EQ(rows, 1 + 2 * scene.methods.size());
  for (const PeerFigures& figures : scene.methods)
    EXPECT_NE(table.str().find(figures.method), std::string::npos);
}

}  // namespace

}  // namespace pelt::tools
