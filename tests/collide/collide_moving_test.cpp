/// The query of two moving characters against the exact test of all pairs of their triangles.

#include <pelt/motion.hpp>

#include "moving_bodies.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace pelt::test {
namespace {

std::vector<Contact> pairs_of(const std::vector<MovingContact>& contacts) {
  std::vector<Contact> pairs;
  for (const MovingContact& c : contacts) pairs.push_back(c.contact);
  return pairs;
}

TEST(CollideMoving, EqualsTheExactTestOfAllPairsOnLimbs) {
  Random random(1801);
  Limbs limbs;
  std::size_t contacts = 0, later = 0;
  int apart = 0;
  for (int round = 0; round < 12; ++round) {
    limbs.move(random, 0.3);
    const auto expected = brute_force(limbs.a, limbs.b);
    ASSERT_EQ(contacts_of(limbs.a, limbs.b), expected) << "round " << round;
    contacts += expected.size();
    apart += expected.empty();
    for (const MovingContact& c : expected) later += !c.at_start;
  }
  std::printf("seed 1801: %zu contacts, %zu not at the start, %d steps without\n", contacts, later,
              apart);
  EXPECT_GT(contacts, 2000u);
  EXPECT_GT(later, 1000u);
  EXPECT_GT(apart, 1);
}

TEST(CollideMoving, EqualsTheExactTestOfAllPairsOnSoups) {
  Random random(1802);
  std::size_t contacts = 0;
  int cases = 0, touching = 0;
  for (const test::Motion motion :
       {test::Motion::rigid, test::Motion::affine, test::Motion::collapsed, test::Motion::far_away})
    for (const std::uint32_t influences : {1u, 4u}) {
      Body a(make_soup(random, 50, 5, influences, Weights::random));
      Body b(make_soup(random, 40, 4, influences, Weights::random));
      const auto palette = [&](std::uint32_t joints) {
        return make_palette(random, joints, motion, 1);
      };
      const auto from_a = palette(5), to_a = palette(5), from_b = palette(4), to_b = palette(4);
      a.move(from_a, to_a);
      b.move(from_b, to_b);
      const auto expected = brute_force(a, b);
      ASSERT_EQ(contacts_of(a, b), expected);
      contacts += expected.size();
      touching += !expected.empty();
      ++cases;
    }
  EXPECT_GT(touching, cases / 2);
  EXPECT_GT(contacts, 500u);
}

TEST(CollideMoving, IsTheSameWithEveryInstructionSet) {
  Random random(1803);
  Limbs limbs;
  limbs.move(random, 0.3);
  const auto expected = contacts_of(limbs.a, limbs.b);
  ASSERT_GT(expected.size(), 50u);
  on_each_instruction_set(
      [&](InstructionSet) { EXPECT_EQ(contacts_of(limbs.a, limbs.b), expected); });
}

TEST(CollideMoving, OfCharactersThatStandStillIsCollide) {
  Random random(1804);
  Limbs limbs;
  limbs.move(random, 0.1);
  Scratch scratch;
  std::vector<Contact> expected;
  collide(limbs.a.from, limbs.b.from, scratch, expected);
  ASSERT_GT(expected.size(), 20u);
  std::vector<MovingContact> found;
  collide({limbs.a.from, limbs.a.from}, {limbs.b.from, limbs.b.from}, scratch, found);
  EXPECT_EQ(pairs_of(found), expected);
  for (const MovingContact& c : found) EXPECT_TRUE(c.at_start && c.time == 0);
}

TEST(CollideMoving, ContainsTheContactsOfBothEnds) {
  Random random(1805);
  Limbs limbs;
  Scratch scratch;
  std::size_t at_ends = 0;
  for (int round = 0; round < 20; ++round) {
    limbs.move(random, 0.3);
    const auto found = pairs_of(contacts_of(limbs.a, limbs.b));
    for (const auto& [a, b] :
         {std::pair(&limbs.a.from, &limbs.b.from), std::pair(&limbs.a.to, &limbs.b.to)}) {
      std::vector<Contact> end;
      collide(*a, *b, scratch, end);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), end.begin(), end.end()));
      at_ends += end.size();
    }
  }
  EXPECT_GT(at_ends, 200u);
}

TEST(CollideMoving, FindsTheSamePairsBackwardsAndSwapped) {
  Random random(1806);
  Limbs limbs;
  Scratch scratch;
  std::size_t seen = 0;
  for (int round = 0; round < 20; ++round) {
    limbs.move(random, 0.3);
    const auto pairs = pairs_of(contacts_of(limbs.a, limbs.b));
    std::vector<MovingContact> backwards, swapped;
    collide({limbs.a.to, limbs.a.from}, {limbs.b.to, limbs.b.from}, scratch, backwards);
    EXPECT_EQ(pairs_of(backwards), pairs);
    collide(limbs.b.step(), limbs.a.step(), scratch, swapped);
    auto turned = pairs_of(swapped);
    for (Contact& c : turned) std::swap(c.triangle_a, c.triangle_b);
    std::sort(turned.begin(), turned.end());
    EXPECT_EQ(turned, pairs);
    seen += pairs.size();
  }
  EXPECT_GT(seen, 500u);
}

TEST(CollideMoving, HasOptionsForTimesAndForContactsAtTheStart) {
  Random random(1807);
  Limbs limbs;
  std::size_t at_start = 0, later = 0;
  for (int round = 0; round < 20; ++round) {
    limbs.move(random, 0.3);
    const auto all = contacts_of(limbs.a, limbs.b);
    std::vector<MovingContact> rest;
    for (const MovingContact& c : all)
      if (!c.at_start) rest.push_back(c);
    EXPECT_EQ(contacts_of(limbs.a, limbs.b, {.leave_out_start = true}), rest);
    EXPECT_EQ(pairs_of(contacts_of(limbs.a, limbs.b, {.times = false})), pairs_of(all));
    EXPECT_EQ(pairs_of(contacts_of(limbs.a, limbs.b, {.leave_out_start = true, .times = false})),
              pairs_of(rest));
    at_start += all.size() - rest.size();
    later += rest.size();
  }
  EXPECT_GT(at_start, 100u);
  EXPECT_GT(later, 500u);
}

TEST(CollideMoving, StopsAtTheLimit) {
  Random random(1808);
  Limbs limbs;
  limbs.move(random, 0.2);
  Scratch scratch;
  const auto all = contacts_of(limbs.a, limbs.b);
  const auto count = static_cast<std::uint32_t>(all.size());
  ASSERT_GT(count, 20u);
  for (const std::uint32_t limit : {0u, 1u, 7u, count, count + 1}) {
    std::vector<MovingContact> some;
    const QueryStats work =
        collide(limbs.a.step(), limbs.b.step(), scratch, some, {.max_contacts = limit});
    EXPECT_EQ(some.size(), std::min(limit, count));
    for (const MovingContact& c : some) EXPECT_NE(std::find(all.begin(), all.end(), c), all.end());
    if (limit != count) {
      EXPECT_EQ(work.cut_short, limit < count);
    }
  }
}

TEST(CollideMoving, TouchWhileMovingIsWhetherThereIsAContact) {
  Random random(1809);
  Limbs limbs;
  Scratch scratch;
  int touching = 0, apart = 0;
  for (int round = 0; round < 60; ++round) {
    limbs.move(random, 0.7);
    const bool expected = !contacts_of(limbs.a, limbs.b).empty();
    EXPECT_EQ(intersects(limbs.a.step(), limbs.b.step(), scratch).answer, expected);
    ++(expected ? touching : apart);
  }
  EXPECT_GT(touching, 10);
  EXPECT_GT(apart, 5);
}

/// A thin blade that is on one side of a limb at the start, and on the other at the end.
TEST(CollideMoving, FindsWhatNoEndOfTheStepShows) {
  Shape blade;
  blade.rest_positions = {{-0.01f, 0.5f, -1}, {0.01f, 0.5f, -1}, {0, 0.5f, 1}};
  blade.triangles = {{0, 1, 2}};
  blade.influences_per_vertex = 1;
  blade.joints = {0, 0, 0};
  blade.weights = {1, 1, 1};
  Body sword(blade), arm(make_limb(24, 10, 3));
  const std::vector<Matrix4> left = {rotation_about({0, 0, 1}, 0, {}, {-1, 0, 0})};
  const std::vector<Matrix4> right = {rotation_about({0, 0, 1}, 0, {}, {1, 0, 0})};
  sword.move(left, right);
  Scratch scratch;
  EXPECT_FALSE(intersects(sword.from, arm.from, scratch).answer);
  EXPECT_FALSE(intersects(sword.to, arm.to, scratch).answer);
  const auto found = contacts_of(sword, arm);
  EXPECT_GT(found.size(), 5u);
  for (const MovingContact& c : found) EXPECT_TRUE(c.time > 0.3f && c.time < 0.7f);
}

TEST(CollideMoving, AllocatesNothingWhenWarm) {
  Random random(1810);
  Limbs limbs;
  limbs.move(random, 0.2);
  Scratch scratch;
  std::vector<MovingContact> contacts;
  const auto ask = [&] {
    contacts.clear();
    collide(limbs.a.step(), limbs.b.step(), scratch, contacts);
  };
  ask();
  ASSERT_GT(contacts.size(), 20u);
  const std::size_t before = allocation_count();
  ask();
  EXPECT_EQ(allocation_count(), before);
}

TEST(CollideMoving, AllocatesNothingAfterReserve) {
  Random random(1811);
  Limbs limbs;
  limbs.move(random, 0.2);
  const std::size_t count = contacts_of(limbs.a, limbs.b).size();
  limbs.move(random, 0.2);
  for (Pose* pose : {&limbs.a.from, &limbs.a.to, &limbs.b.from, &limbs.b.to}) pose->reserve();
  Scratch scratch;
  scratch.reserve(4 * count);
  std::vector<MovingContact> contacts;
  contacts.reserve(4 * count);
  const std::size_t before = allocation_count();
  collide(limbs.a.step(), limbs.b.step(), scratch, contacts);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_GT(contacts.size(), 20u);
}

TEST(CollideMoving, RefusesAPoseInBothSteps) {
  Limbs limbs;
  Scratch scratch;
  std::vector<MovingContact> contacts;
  EXPECT_DEATH(collide(limbs.a.step(), {limbs.a.to, limbs.a.to}, scratch, contacts),
               "Motion: `a` and `b` have a pose in common");
  EXPECT_DEATH(collide({limbs.a.from, limbs.b.from}, limbs.b.step(), scratch, contacts),
               "Motion: the poses of a motion are of different models");
}

}  // namespace
}  // namespace pelt::test
