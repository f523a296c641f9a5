/// The query of two moving characters against the exact test of all pairs of their triangles.

#include <pelt/motion.hpp>

#include "moving_bodies.hpp"

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

TEST(CollideMoving, FindsTheSamePairsBackwards) {
  Random random(1806);
  Limbs limbs;
  Scratch scratch;
  std::size_t seen = 0;
  for (int round = 0; round < 20; ++round) {
    limbs.move(random, 0.3);
    const auto pairs = pairs_of(contacts_of(limbs.a, limbs.b));
    std::vector<MovingContact> backwards;
    collide({limbs.a.to, limbs.a.from}, {limbs.b.to, limbs.b.from}, scratch, backwards);
    EXPECT_EQ(pairs_of(backwards), pairs);
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
