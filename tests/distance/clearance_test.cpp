#include <pelt/distance.hpp>

#include "brute_distance.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using test::brute_clearance;
using test::Limbs;
using test::Motion;
using test::posed_triangles;
using test::Random;
using test::Shape;

std::vector<Contact> clearance_of(Pose& a, Pose& b, double tolerance, Scratch& scratch) {
  std::vector<Contact> pairs;
  clearance(a, b, tolerance, scratch, pairs);
  return pairs;
}

TEST(Clearance, EqualsBruteForceOnBendingLimbs) {
  Random random(140);
  Limbs limbs;
  std::size_t pairs = 0, touching = 0;
  for (int round = 0; round < 30; ++round) {
    limbs.move(random, 0.4);
    const auto a = limbs.triangles_a(), b = limbs.triangles_b();
    for (const double tolerance : {0.0, 0.01, 0.1}) {
      const auto expected = brute_clearance(a, b, tolerance);
      ASSERT_EQ(clearance_of(limbs.a, limbs.b, tolerance, limbs.scratch), expected);
      ASSERT_EQ(is_within(limbs.a, limbs.b, tolerance, limbs.scratch).answer, !expected.empty());
      pairs += expected.size();
      touching += tolerance == 0 && !expected.empty();
    }
  }
  EXPECT_GT(pairs, 1000u);
  EXPECT_GT(touching, 3u);
  EXPECT_LT(touching, 27u);
}

TEST(Clearance, EqualsBruteForceOnSoupsUnderAnyAffineJoints) {
  Random random(141);
  Scratch scratch;
  std::size_t pairs = 0;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (int round = 0; round < 4; ++round) {
      const Shape a = test::make_soup(random, 90, 6, 3, test::Weights::random);
      const Shape b = test::make_soup(random, 80, 5, 4, test::Weights::adversarial);
      Pose pose_a(*build_model(a.view())), pose_b(*build_model(b.view()));
      ASSERT_TRUE(pose_a.set_palette(test::make_palette(random, 6, motion, 1)));
      ASSERT_TRUE(pose_b.set_palette(test::make_palette(random, 5, motion, 1)));
      const auto expected = brute_clearance(posed_triangles(a.triangles, pose_a),
                                            posed_triangles(b.triangles, pose_b), 0.05);
      ASSERT_EQ(clearance_of(pose_a, pose_b, 0.05, scratch), expected);
      pairs += expected.size();
    }
  EXPECT_GT(pairs, 1000u);
}

TEST(Clearance, OfZeroIsCollide) {
  Random random(142);
  Limbs limbs;
  std::size_t seen = 0;
  for (int round = 0; round < 50; ++round) {
    limbs.move(random, 0.2);
    std::vector<Contact> contacts;
    collide(limbs.a, limbs.b, limbs.scratch, contacts);
    ASSERT_EQ(clearance_of(limbs.a, limbs.b, 0, limbs.scratch), contacts);
    seen += contacts.size();
  }
  EXPECT_GT(seen, 200u);
}

TEST(Clearance, BeginsAtTheDistance) {
  Random random(143);
  Limbs limbs;
  int apart = 0;
  for (int round = 0; round < 40; ++round) {
    limbs.move(random, 2);
    Distance closest;
    distance(limbs.a, limbs.b, limbs.scratch, closest);
    if (closest.distance == 0) continue;
    ++apart;
    const double less = std::nextafter(closest.distance, 0);
    EXPECT_FALSE(is_within(limbs.a, limbs.b, less, limbs.scratch));
    EXPECT_TRUE(is_within(limbs.a, limbs.b, closest.distance, limbs.scratch));
    const auto pairs = clearance_of(limbs.a, limbs.b, closest.distance, limbs.scratch);
    ASSERT_FALSE(pairs.empty());
    EXPECT_EQ(pairs[0], (Contact{closest.a.triangle, closest.b.triangle}));
  }
  EXPECT_GT(apart, 20);
}

TEST(Clearance, StopsAtTheLimit) {
  Random random(144);
  Limbs limbs;
  limbs.move(random, 0.1);
  const double tolerance = 0.05;
  const auto all = clearance_of(limbs.a, limbs.b, tolerance, limbs.scratch);
  const auto count = static_cast<std::uint32_t>(all.size());
  ASSERT_GT(count, 20u);
  for (const std::uint32_t limit : {0u, 1u, 9u, count / 2, count - 1, count, count + 1}) {
    std::vector<Contact> some;
    const QueryStats stats =
        clearance(limbs.a, limbs.b, tolerance, limbs.scratch, some, {.max_contacts = limit});
    EXPECT_EQ(some.size(), std::min(limit, count));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    EXPECT_EQ(stats.cut_short, limit < count);
  }
}

}  // namespace
}  // namespace pelt
