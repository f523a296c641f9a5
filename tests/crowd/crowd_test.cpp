#include <pelt/crowd.hpp>
#include <pelt/target.hpp>

#include "support/allocation_count.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <thread>

namespace pelt {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

constexpr std::uint32_t kThreadCounts[] = {1, 2, 3, 8};

/// Instances of several models with their poses, as a crowd and one by one.
struct TestCrowd {
  explicit TestCrowd(std::vector<Shape> shapes) {
    for (const Shape& shape : shapes) models.push_back(*build_model(shape.view()));
  }

  std::uint32_t add(std::uint32_t model, const CrowdGroups& groups = {}) {
    const std::uint32_t instance = crowd.add(models[model], groups);
    if (instance == poses.size()) {
      poses.emplace_back(models[model]);
      all_groups.push_back(groups);
      present.push_back(true);
    } else {
      poses[instance] = Pose(models[model]);
      all_groups[instance] = groups;
      present[instance] = true;
    }
    return instance;
  }

  void remove(std::uint32_t instance) {
    crowd.remove(instance);
    present[instance] = false;
  }

  void move(std::uint32_t instance, const std::vector<Matrix4>& palette) {
    ASSERT_TRUE(crowd.set_palette(instance, palette));
    ASSERT_TRUE(poses[instance].set_palette(palette));
  }

  bool may_touch(std::uint32_t a, std::uint32_t b) const {
    return (all_groups[a].member_of & all_groups[b].collides_with) != 0 &&
           (all_groups[b].member_of & all_groups[a].collides_with) != 0;
  }

  /// Every pair asked by itself.
  std::vector<CrowdContact> expected(const CrowdOptions& options = {}) {
    std::vector<CrowdContact> all;
    Scratch scratch;
    for (std::uint32_t a = 0; a < poses.size(); ++a)
      for (std::uint32_t b = a + 1; b < poses.size(); ++b) {
        if (!present[a] || !present[b] || !may_touch(a, b)) continue;
        if (options.filter && !options.filter(a, b)) continue;
        std::vector<Contact> contacts;
        pelt::collide(poses[a], poses[b], scratch, contacts, {options.max_contacts});
        for (const Contact& c : contacts) all.push_back({a, b, c.triangle_a, c.triangle_b});
      }
    return all;
  }

  std::vector<CrowdContact> contacts(const CrowdOptions& options = {}) {
    std::vector<CrowdContact> found;
    crowd.collide(found, options);
    return found;
  }

  std::vector<SkinnedModel> models;
  Crowd crowd;
  std::vector<Pose> poses;
  std::vector<CrowdGroups> all_groups;
  std::vector<bool> present;
};

std::vector<CrowdPair> pairs_of(const std::vector<CrowdContact>& contacts) {
  std::vector<CrowdPair> pairs;
  for (const CrowdContact& c : contacts) pairs.push_back({c.instance_a, c.instance_b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Limbs of two models and a soup, and room for them.
std::vector<Shape> mixed_shapes(Random& random) {
  return {test::make_limb(12, 8, 3), test::make_limb(20, 6, 5),
          test::make_soup(random, 60, 4, 3, Weights::random)};
}

std::vector<Matrix4> palette_for(Random& random, std::uint32_t model, double room) {
  if (model == 2) {
    std::vector<Matrix4> palette = test::make_palette(random, 4, Motion::affine, 0.3);
    const Vec3 place = random.point(room);
    for (Matrix4& m : palette) m.m[12] += place.x, m.m[13] += place.y, m.m[14] += place.z;
    return palette;
  }
  return test::bend_limb(random, model == 0 ? 3 : 5, random.uniform(-0.6, 0.6), random.point(room));
}

TestCrowd make_mixed_crowd(Random& random, std::uint32_t count, double room) {
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t model = random.index(3);
    const std::uint32_t instance = crowd.add(model);
    crowd.move(instance, palette_for(random, model, room));
  }
  return crowd;
}

bool operator==(const QueryStats& a, const QueryStats& b) {
  return a.node_pairs == b.node_pairs && a.refits == b.refits &&
         a.posed_vertices == b.posed_vertices && a.triangle_pairs == b.triangle_pairs &&
         a.cut_short == b.cut_short;
}

std::uint32_t model_of(const TestCrowd& crowd, std::uint32_t instance) {
  const auto found =
      std::find_if(crowd.models.begin(), crowd.models.end(), [&](const SkinnedModel& model) {
        return &model.detail() == &crowd.crowd.model(instance).detail();
      });
  return static_cast<std::uint32_t>(found - crowd.models.begin());
}

TEST(Crowd, EqualsAllPairsOneByOneWithAnyTargetAndNumberOfThreads) {
  Random random(30);
  const Target fastest = active_target();
  std::size_t contacts = 0, touching = 0, apart = 0;
  for (int round = 0; round < 12; ++round) {
    const std::uint32_t count = 2 + random.index(25);
    TestCrowd crowd = make_mixed_crowd(random, count, 1.5);
    const auto expected = crowd.expected();
    const auto expected_pairs = pairs_of(expected);
    for (const Target target : available_targets())
      for (const std::uint32_t threads : kThreadCounts) {
        ASSERT_TRUE(set_active_target(target));
        ASSERT_EQ(crowd.contacts({.threads = threads}), expected) << "round " << round;
        std::vector<CrowdPair> pairs;
        crowd.crowd.touching(pairs, {.threads = threads});
        ASSERT_EQ(pairs, expected_pairs);
      }
    contacts += expected.size();
    touching += expected_pairs.size();
    apart += count * (count - 1) / 2 - expected_pairs.size();
  }
  ASSERT_TRUE(set_active_target(fastest));
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(touching, 100u);
  EXPECT_GT(apart, 300u);
}

TEST(Crowd, StatsDoNotDependOnThreadsOrTargets) {
  Random random(31);
  const Target fastest = active_target();
  TestCrowd crowd = make_mixed_crowd(random, 40, 1.5);
  std::vector<std::vector<Matrix4>> palettes;
  for (std::uint32_t i = 0; i < 40; ++i)
    palettes.push_back(palette_for(random, model_of(crowd, i), 1.5));
  std::vector<CrowdContact> contacts;
  const auto ask_anew = [&](std::uint32_t threads) {
    for (std::uint32_t i = 0; i < 40; ++i) EXPECT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
    contacts.clear();
    return crowd.crowd.collide(contacts, {.threads = threads});
  };
  const CrowdStats expected = ask_anew(1);
  const auto expected_contacts = contacts;
  EXPECT_GT(expected.touching_pairs, 30u);
  EXPECT_GT(expected.candidate_pairs, expected.touching_pairs);
  EXPECT_GT(expected.work.refits, 500u);
  EXPECT_GT(expected.work.posed_vertices, 1000u);
  EXPECT_GT(expected.work.triangle_pairs, 1000u);
  for (const Target target : available_targets()) {
    ASSERT_TRUE(set_active_target(target));
    for (int repeat = 0; repeat < 10; ++repeat)
      for (const std::uint32_t threads : kThreadCounts) {
        const CrowdStats stats = ask_anew(threads);
        ASSERT_TRUE(stats.work == expected.work) << threads << " threads";
        ASSERT_EQ(stats.candidate_pairs, expected.candidate_pairs);
        ASSERT_EQ(stats.touching_pairs, expected.touching_pairs);
        ASSERT_EQ(contacts, expected_contacts);
      }
  }
  ASSERT_TRUE(set_active_target(fastest));
}

TEST(Crowd, OpensANodeOnceHoweverManyPairsAsk) {
  Random random(32);
  TestCrowd crowd = make_mixed_crowd(random, 30, 0.8);
  Scratch scratch;
  std::vector<Contact> contacts;
  for (const std::uint32_t threads : kThreadCounts) {
    for (std::uint32_t i = 0; i < 30; ++i)
      crowd.move(i, palette_for(random, model_of(crowd, i), 0.8));
    QueryStats one_by_one;
    for (std::uint32_t a = 0; a < 30; ++a)
      for (std::uint32_t b = a + 1; b < 30; ++b)
        one_by_one += pelt::collide(crowd.poses[a], crowd.poses[b], scratch, contacts);
    std::vector<CrowdContact> found;
    const QueryStats work = crowd.crowd.collide(found, {.threads = threads}).work;
    EXPECT_EQ(work.refits, one_by_one.refits);
    EXPECT_EQ(work.posed_vertices, one_by_one.posed_vertices);
    EXPECT_EQ(work.triangle_pairs, one_by_one.triangle_pairs);
    EXPECT_GT(work.refits, 300u);
  }
}

TEST(Crowd, ForgetsWhatItOpened) {
  Random random(45);
  TestCrowd crowd = make_mixed_crowd(random, 15, 0.5);
  for (int frame = 0; frame < 30; ++frame) {
    for (std::uint32_t i = 0; i < 15; ++i)
      if (random.chance(0.3)) crowd.move(i, palette_for(random, model_of(crowd, i), 0.5));
    ASSERT_EQ(crowd.contacts(), crowd.expected()) << "frame " << frame;
  }
}

TEST(Crowd, AppendsInAscendingOrder) {
  Random random(33);
  TestCrowd crowd = make_mixed_crowd(random, 15, 0.5);
  std::vector<CrowdContact> contacts = {{9, 9, 9, 9}};
  std::vector<CrowdPair> pairs = {{9, 9}};
  crowd.crowd.collide(contacts);
  crowd.crowd.touching(pairs);
  ASSERT_GT(contacts.size(), 100u);
  ASSERT_GT(pairs.size(), 10u);
  EXPECT_EQ(contacts[0], (CrowdContact{9, 9, 9, 9}));
  EXPECT_EQ(pairs[0], (CrowdPair{9, 9}));
  EXPECT_TRUE(std::is_sorted(contacts.begin() + 1, contacts.end()));
  EXPECT_TRUE(std::is_sorted(pairs.begin() + 1, pairs.end()));
}

TEST(Crowd, GroupsMustAgreeOnBothSides) {
  Random random(34);
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < 30; ++i) {
    const std::uint32_t model = random.index(3);
    const CrowdGroups groups = {1u << random.index(4), random.index(16)};
    crowd.move(crowd.add(model, groups), palette_for(random, model, 0.7));
  }
  const auto all = crowd.contacts();
  EXPECT_EQ(all, crowd.expected());
  EXPECT_GT(pairs_of(all).size(), 20u);
  for (std::uint32_t i = 0; i < 30; ++i) {
    crowd.all_groups[i] = {};
    crowd.crowd.set_groups(i, {});
  }
  EXPECT_GT(pairs_of(crowd.contacts()).size(), 2 * pairs_of(all).size());
  EXPECT_EQ(crowd.contacts(), crowd.expected());
}

TEST(Crowd, FilterIsAskedOnceForEachPairWithALessThanB) {
  Random random(35);
  TestCrowd crowd = make_mixed_crowd(random, 30, 0.7);
  std::vector<CrowdPair> asked;
  CrowdOptions options;
  options.filter = [&](std::uint32_t a, std::uint32_t b) {
    asked.push_back({a, b});
    return (a + b) % 3 != 0;
  };
  std::vector<CrowdContact> contacts;
  const CrowdStats stats = crowd.crowd.collide(contacts, options);
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end());
  for (const CrowdPair& pair : asked) EXPECT_LT(pair.instance_a, pair.instance_b);
  EXPECT_LT(stats.candidate_pairs, asked.size());
  EXPECT_EQ(contacts, crowd.expected(options));
  EXPECT_LT(contacts.size(), crowd.contacts().size());
  EXPECT_GT(contacts.size(), 100u);
}

TEST(Crowd, StopsEachPairAtTheLimit) {
  Random random(36);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto all = crowd.contacts();
  const auto pairs = pairs_of(all);
  for (const std::uint32_t limit : {0u, 1u, 7u}) {
    std::vector<CrowdContact> some;
    const CrowdStats stats = crowd.crowd.collide(some, {.max_contacts = limit});
    EXPECT_TRUE(stats.work.cut_short);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    for (const CrowdPair& pair : pairs) {
      const auto count = [&](const std::vector<CrowdContact>& contacts) {
        return std::count_if(contacts.begin(), contacts.end(), [&](const CrowdContact& c) {
          return CrowdPair{c.instance_a, c.instance_b} == pair;
        });
      };
      EXPECT_EQ(count(some), std::min<std::ptrdiff_t>(limit, count(all)));
    }
    std::vector<CrowdContact> with_threads;
    crowd.crowd.collide(with_threads, {.threads = 3, .max_contacts = limit});
    EXPECT_EQ(with_threads, some);
  }
}

TEST(Crowd, InstancesCanBeRemovedAndTheirNumbersGivenAnew) {
  Random random(37);
  TestCrowd crowd = make_mixed_crowd(random, 20, 0.7);
  std::uint32_t size = 20;
  std::size_t contacts = 0;
  for (int round = 0; round < 60; ++round) {
    const std::uint32_t instance = random.index(20);
    if (crowd.present[instance]) {
      crowd.remove(instance);
      --size;
    } else {
      const std::uint32_t model = random.index(3);
      const std::uint32_t added = crowd.add(model);
      ASSERT_LT(added, 20u);
      if (random.chance(0.7)) crowd.move(added, palette_for(random, model, 0.7));
      ++size;
    }
    ASSERT_EQ(crowd.crowd.size(), size);
    const auto expected = crowd.expected();
    ASSERT_EQ(crowd.contacts(), expected) << "round " << round;
    contacts += expected.size();
  }
  EXPECT_GT(contacts, 10000u);
}

TEST(Crowd, ABadPaletteLeavesTheInstanceAsItWas) {
  Random random(38);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto before = crowd.contacts();
  ASSERT_GT(before.size(), 100u);
  for (std::uint32_t i = 0; i < 12; ++i) {
    auto palette = palette_for(random, model_of(crowd, i), 0.5);
    palette.back().m[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(crowd.crowd.set_palette(i, palette));
    palette.pop_back();
    const Result<void> refused = crowd.crowd.set_palette(i, palette);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("expected"), std::string::npos);
  }
  EXPECT_EQ(crowd.contacts(), before);
}

TEST(Crowd, OfNobodyOrOneHasNoContacts) {
  Crowd crowd;
  std::vector<CrowdContact> contacts;
  EXPECT_EQ(crowd.collide(contacts).candidate_pairs, 0u);
  const auto limb = test::make_limb(12, 8, 3);
  EXPECT_EQ(crowd.add(*build_model(limb.view())), 0u);
  const CrowdStats stats = crowd.collide(contacts);
  EXPECT_EQ(stats.candidate_pairs, 0u);
  EXPECT_EQ(stats.work.refits, 1u) << "its box";
  EXPECT_EQ(stats.work.posed_vertices, 0u);
  EXPECT_TRUE(contacts.empty());
  EXPECT_EQ(crowd.model(0).joint_count(), 3u);
}

TEST(Crowd, FarApartCostsABoxEach) {
  Random random(39);
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < 300; ++i)
    crowd.move(crowd.add(0), test::bend_limb(random, 3, 0.2,
                                             {static_cast<float>(i % 7) * 5, 0,
                                              static_cast<float>(i / 7) * 5 - 1000}));
  std::vector<CrowdContact> contacts;
  const CrowdStats stats = crowd.crowd.collide(contacts);
  EXPECT_EQ(stats.candidate_pairs, 0u);
  EXPECT_EQ(stats.work.refits, 300u);
  EXPECT_EQ(stats.work.node_pairs, 0u);
  EXPECT_TRUE(contacts.empty());
}

TEST(Crowd, AllInOnePlaceTouchEachOther) {
  TestCrowd crowd({test::make_limb(12, 8, 3)});
  for (std::uint32_t i = 0; i < 25; ++i) crowd.add(0);
  std::vector<CrowdPair> pairs;
  const CrowdStats stats = crowd.crowd.touching(pairs);
  EXPECT_EQ(pairs.size(), 25u * 24 / 2);
  EXPECT_EQ(stats.touching_pairs, pairs.size());
  EXPECT_EQ(crowd.contacts(), crowd.expected());
}

TEST(Crowd, SpreadAlongAnyAxisAndAtAnySizeIsFoundByTheSweep) {
  Random random(40);
  for (int axis = 0; axis < 3; ++axis)
    for (const double scale : {1e-3, 1.0, 1e6}) {
      TestCrowd crowd({test::make_limb(8, 5, 1)});
      for (std::uint32_t i = 0; i < 60; ++i) {
        float place[3] = {random.uniformf(-0.1, 0.1), random.uniformf(-0.1, 0.1),
                          random.uniformf(-0.1, 0.1)};
        place[axis] = random.uniformf(-8, 8);
        Matrix4 m;
        for (std::size_t k = 0; k < 3; ++k) {
          m.m[5 * k] = static_cast<float>(scale);
          m.m[12 + k] = static_cast<float>(scale) * place[k];
        }
        crowd.move(crowd.add(0), {m});
      }
      const auto expected = crowd.expected();
      EXPECT_GT(expected.size(), 100u);
      EXPECT_EQ(crowd.contacts(), expected);
    }
}

TEST(Crowd, PalettesOfDifferentInstancesCanBeSetAtOnce) {
  Random random(41);
  TestCrowd crowd = make_mixed_crowd(random, 40, 0.8);
  std::vector<std::vector<Matrix4>> palettes;
  for (std::uint32_t i = 0; i < 40; ++i) {
    palettes.push_back(palette_for(random, model_of(crowd, i), 0.8));
    ASSERT_TRUE(crowd.poses[i].set_palette(palettes[i]));
  }
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < 4; ++t)
    threads.emplace_back([&crowd, &palettes, t] {
      for (std::uint32_t i = t; i < 40; i += 4)
        EXPECT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
    });
  for (std::thread& thread : threads) thread.join();
  const auto expected = crowd.expected();
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_EQ(crowd.contacts({.threads = 4}), expected);
}

TEST(Crowd, CanBeMoved) {
  Random random(42);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto expected = crowd.contacts({.threads = 2});
  Crowd other = std::move(crowd.crowd);
  std::vector<CrowdContact> contacts;
  other.collide(contacts, {.threads = 2});
  EXPECT_EQ(contacts, expected);
  EXPECT_EQ(other.size(), 12u);
}

TEST(Crowd, ARepeatedFrameAllocatesNothing) {
  for (const std::uint32_t threads : kThreadCounts) {
    Random random(43);
    TestCrowd crowd = make_mixed_crowd(random, 60, 1);
    std::vector<std::vector<Matrix4>> palettes;
    for (std::uint32_t i = 0; i < 60; ++i)
      palettes.push_back(palette_for(random, model_of(crowd, i), 1));
    std::vector<CrowdContact> contacts;
    std::vector<CrowdPair> pairs;
    contacts.reserve(1 << 18);
    pairs.reserve(1 << 12);
    for (int frame = 0; frame < 8; ++frame) {
      contacts.clear();
      pairs.clear();
      const std::size_t before = test::allocation_count();
      for (std::uint32_t i = 0; i < 60; ++i) ASSERT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
      crowd.crowd.collide(contacts, {.threads = threads});
      crowd.crowd.touching(pairs, {.threads = threads});
      if (frame > 0) {
        ASSERT_EQ(test::allocation_count(), before) << "frame " << frame << ", " << threads;
      }
    }
    EXPECT_GT(contacts.size(), 1000u);
    EXPECT_LT(contacts.size(), 1u << 18);
  }
}

TEST(Crowd, MemoryGrowsWithWhatIsOpenedNotWithTheModel) {
  const Shape fine = test::make_limb(300, 60, 5);
  const SkinnedModel model = *build_model(fine.view());
  Random random(44);
  Crowd crowd;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    ASSERT_EQ(crowd.add(model), i);
    const Vec3 place = {static_cast<float>(i % 32) * 3, 0, static_cast<float>(i / 32) * 3};
    ASSERT_TRUE(crowd.set_palette(i, test::bend_limb(random, 5, 0.2, place)));
  }
  std::vector<CrowdContact> contacts;
  ASSERT_EQ(crowd.collide(contacts).candidate_pairs, 0u);
  EXPECT_LT(crowd.memory(), 1000u * 1000) << "a kilobyte an instance, of which 320 are its palette";

  const std::size_t before = crowd.memory();
  for (std::uint32_t i = 0; i < 1000; i += 100)
    ASSERT_TRUE(crowd.set_palette(i, test::bend_limb(random, 5, 0.2, {500, 0, 0})));
  ASSERT_GT(crowd.collide(contacts, {.threads = 1}).touching_pairs, 10u);
  EXPECT_GT(crowd.memory(), before);
  EXPECT_LT(crowd.memory(), before + 20u * 36000 * 50);
}

}  // namespace
}  // namespace pelt
