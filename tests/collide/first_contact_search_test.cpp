#include <pelt/search.hpp>

#include "collide/moving_search_bodies.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

constexpr std::uint64_t kUnlimited = UINT64_MAX;

/// Two limbs. The second moves along x, from one place to another.
struct PassingLimbs {
  Body a = Body(make_limb(24, 10, 5)), b = Body(make_limb(17, 9, 4));

  PassingLimbs(float from, float to) {
    a.move(at(5, 0), at(5, 0));
    b.move(at(4, from), at(4, to));
  }

  static std::vector<Matrix4> at(std::uint32_t joints, float x) {
    Random random(640);
    return bend_limb(random, joints, 0.3, {x, 0, 0});
  }
};

TEST(FirstContactSearch, StartsUnknownAndEndsTouching) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  EXPECT_EQ(search.verdict(), Verdict::unknown);
  EXPECT_EQ(search.apart_until(), 0);
  EXPECT_FALSE(search.earliest());
  const MovingStats stats = search.advance(kUnlimited);
  EXPECT_FALSE(stats.cut_short);
  EXPECT_GT(stats.double_pairs, 0u);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::touching);
  const auto first = first_of(limbs.a, limbs.b, false);
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->at_start);
  EXPECT_EQ(search.earliest(), first);
  EXPECT_EQ(search.apart_until(), first->time);
}

TEST(FirstContactSearch, KnowsMoreAfterHalfOfTheWork) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  search.advance(kUnlimited);
  const std::uint64_t all = search.work_done();
  const float time = search.earliest()->time;
  search.restart();
  const MovingStats stats = search.advance(all / 2);
  EXPECT_TRUE(stats.cut_short);
  EXPECT_GT(search.apart_until(), 0.5f * time);
  EXPECT_LE(search.apart_until(), time);
}

TEST(FirstContactSearch, DistantBodiesAreApartAtOnce) {
  PassingLimbs limbs(4, 5);
  const FirstContactSearch search(limbs.a.step(), limbs.b.step());
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::apart);
  EXPECT_EQ(search.apart_until(), 1);
  EXPECT_FALSE(search.earliest());
}

TEST(FirstContactSearch, TakesAboutTheWorkOfFirstContact) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  const MovingStats found = search.advance(kUnlimited);
  for (Pose* pose : {&limbs.a.from, &limbs.a.to, &limbs.b.from, &limbs.b.to}) pose->reserve();
  Scratch scratch;
  std::optional<MovingContact> first;
  const MovingStats expected = first_contact(limbs.a.step(), limbs.b.step(), scratch, first);
  EXPECT_LE(found.posed_vertices, expected.posed_vertices);
  EXPECT_LE(found.triangle_pairs, expected.triangle_pairs);
}

TEST(FirstContactSearch, ABudgetIsExceededByLessThanTheLongestStep) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  const std::uint64_t start = search.work_done();
  std::uint64_t granted = 0;
  while (!search.is_complete()) {
    granted += 10;
    search.advance(10);
    ASSERT_LT(search.work_done() - start, granted + search.longest_step());
  }
  EXPECT_LT(search.longest_step(), 30'000u);
}

TEST(FirstContactSearch, OpensOnePoseOfAMotionThatStandsStill) {
  PassingLimbs limbs(-1, 1);
  Pose copy(limbs.a.from.model());
  ASSERT_TRUE(copy.set_palette(PassingLimbs::at(5, 0)));
  FirstContactSearch twice({limbs.a.from, copy}, limbs.b.step());
  FirstContactSearch once({limbs.a.from, limbs.a.from}, limbs.b.step());
  twice.advance(kUnlimited);
  once.advance(kUnlimited);
  EXPECT_EQ(once.earliest(), twice.earliest());
  EXPECT_LT(once.work_done(), twice.work_done());
}

TEST(FirstContactSearch, OpensOnlyTheFirstPosesOnceBodiesTouchAtTheStart) {
  PassingLimbs limbs(0.05f, 0.1f);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  const MovingStats stats = search.advance(kUnlimited);
  ASSERT_TRUE(search.earliest()->at_start);
  EXPECT_EQ(search.apart_until(), 0);
  limbs.a.from.reserve();  // closes all nodes
  limbs.b.from.reserve();
  Scratch scratch;
  std::vector<Contact> contacts;
  const QueryStats at_start = collide(limbs.a.from, limbs.b.from, scratch, contacts);
  EXPECT_GT(contacts.size(), 20u);
  EXPECT_LT(2 * stats.posed_vertices, 3 * at_start.posed_vertices);
}

TEST(FirstContactSearch, BecomesStaleWithANewPaletteOfAnyPose) {
  PassingLimbs limbs(-1, 1);
  for (Pose* pose : {&limbs.a.from, &limbs.a.to, &limbs.b.from, &limbs.b.to}) {
    FirstContactSearch search(limbs.a.step(), limbs.b.step());
    search.advance(500);
    EXPECT_FALSE(search.is_stale());
    const bool is_a = pose == &limbs.a.from || pose == &limbs.a.to;
    ASSERT_TRUE(pose->set_palette(PassingLimbs::at(is_a ? 5 : 4, 0.2f)));
    EXPECT_TRUE(search.is_stale());
#ifdef NDEBUG
    const std::uint64_t before = search.work_done();
    search.advance(kUnlimited);
    EXPECT_EQ(search.work_done(), before);
#endif
    search.restart();
    EXPECT_FALSE(search.is_stale());
    while (!search.is_complete()) search.advance(500);
    EXPECT_EQ(search.earliest(), first_of(limbs.a, limbs.b, false));
  }
}

TEST(FirstContactSearch, ARestartForgetsTheFormerSearch) {
  PassingLimbs limbs(0.05f, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  for (const auto& [from, to] : {std::pair(0.05f, 1.0f), std::pair(-0.6f, 1.0f),
                                 std::pair(-1.0f, 0.5f), std::pair(2.0f, 3.0f)}) {
    limbs.b.move(PassingLimbs::at(4, from), PassingLimbs::at(4, to));
    search.restart();
    search.advance(kUnlimited);
    EXPECT_EQ(search.earliest(), first_of(limbs.a, limbs.b, false));
    FirstContactSearch anew(limbs.a.step(), limbs.b.step());
    anew.advance(kUnlimited);
    EXPECT_EQ(search.work_done(), anew.work_done());
  }
  EXPECT_EQ(search.verdict(), Verdict::apart);
}

TEST(FirstContactSearch, MovesWithItsPoses) {
  PassingLimbs limbs(-1, 1);
  const auto first = first_of(limbs.a, limbs.b, false);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  search.advance(100);
  const Pose moved_pose = std::move(limbs.a.from);
  FirstContactSearch moved = std::move(search);
  EXPECT_FALSE(moved.is_stale());
  moved.advance(kUnlimited);
  EXPECT_EQ(moved.earliest(), first);
}

using FirstContactSearchDeathTest = testing::Test;

TEST(FirstContactSearchDeathTest, ASharedPoseAborts) {
  PassingLimbs limbs(-1, 1);
  EXPECT_DEATH(FirstContactSearch(limbs.a.step(), {limbs.a.to, limbs.a.to}),
               "have a pose in common");
}

}  // namespace
}  // namespace pelt::test
