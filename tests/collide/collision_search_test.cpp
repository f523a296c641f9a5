#include <pelt/search.hpp>

#include "collide/contacts_of.hpp"
#include "collide/search_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using test::Random;
using test::SearchBodies;

constexpr std::uint64_t kUnlimited = UINT64_MAX;

/// Limbs that touch at a distance of 0.05, and are apart at 5.
SearchBodies limbs(double distance) {
  Random random(630);
  SearchBodies bodies(test::make_limb(24, 10, 5), test::make_limb(17, 9, 4));
  const auto offset = static_cast<float>(distance);
  bodies.set(test::bend_limb(random, 5, 0.3, {}), test::bend_limb(random, 4, 0.3, {offset, 0, 0}));
  return bodies;
}

TEST(CollisionSearch, StartsUnknownAndEndsTouching) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
  EXPECT_EQ(search.verdict(), Verdict::unknown);
  EXPECT_EQ(search.undecided_pairs(),
            std::uint64_t{bodies.a.model().triangle_count()} * bodies.b.model().triangle_count());
  EXPECT_GT(search.resolution(), 0);
  const QueryStats stats = search.advance(kUnlimited, bodies.scratch);
  EXPECT_FALSE(stats.cut_short);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::touching);
  EXPECT_TRUE(std::is_sorted(search.contacts().begin(), search.contacts().end()));
}

TEST(CollisionSearch, DistantBodiesAreApartAtOnce) {
  SearchBodies bodies = limbs(5);
  const CollisionSearch search(bodies.a, bodies.b);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::apart);
  EXPECT_GT(search.distance_bound(), 4.5);
}

TEST(CollisionSearch, StopsAtTheFirstContactInThatOrderOnly) {
  SearchBodies bodies = limbs(0.05);
  const std::size_t all = test::contacts_of(bodies.a, bodies.b, bodies.scratch).size();
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::first_contact);
  const QueryStats first = search.advance(kUnlimited, bodies.scratch);
  EXPECT_TRUE(first.cut_short);
  EXPECT_EQ(search.verdict(), Verdict::touching);
  EXPECT_GT(search.contacts().size(), 0u);
  EXPECT_LT(search.contacts().size(), all);
  search.advance(1, bodies.scratch);
  EXPECT_FALSE(search.is_complete());
  search.advance(kUnlimited, bodies.scratch);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.contacts().size(), all);
}

TEST(CollisionSearch, FirstContactTakesAboutTheWorkOfIntersects) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::first_contact);
  const QueryStats first = search.advance(kUnlimited, bodies.scratch);
  bodies.a.reserve();
  bodies.b.reserve();
  const QueryStats expected = intersects(bodies.a, bodies.b, bodies.scratch);
  EXPECT_LE(first.posed_vertices, expected.posed_vertices);
  EXPECT_LE(work_of(first), work_of(expected) * 11 / 10);
}

TEST(CollisionSearch, ExceedsItsWorkByLessThanTheLongestStep) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
  const std::uint64_t start = search.work_done();
  std::uint64_t granted = 0;
  while (!search.is_complete()) {
    granted += 10;
    search.advance(10, bodies.scratch);
    ASSERT_LT(search.work_done() - start, granted + search.longest_step());
  }
  EXPECT_LT(search.longest_step(), 1000u);
}

TEST(CollisionSearch, BecomesStaleWithANewPaletteAndCanBeRestarted) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::resolution);
  search.advance(500, bodies.scratch);
  EXPECT_FALSE(search.is_stale());
  Random random(631);
  ASSERT_TRUE(bodies.b.set_palette(test::bend_limb(random, 4, 0.3, {0.1f, 0, 0})));
  EXPECT_TRUE(search.is_stale());
#ifdef NDEBUG
  const std::uint64_t before = search.work_done();
  search.advance(kUnlimited, bodies.scratch);
  EXPECT_EQ(search.work_done(), before);
#endif
  search.restart();
  EXPECT_FALSE(search.is_stale());
  while (!search.is_complete()) search.advance(500, bodies.scratch);
  const auto expected = test::contacts_of(bodies.a, bodies.b, bodies.scratch);
  EXPECT_TRUE(std::equal(search.contacts().begin(), search.contacts().end(), expected.begin(),
                         expected.end()));
}

TEST(CollisionSearch, BecomesStaleWithNewMorphWeights) {
  SearchBodies bodies(test::make_morphing_limb(20, 10, 4), test::make_limb(17, 9, 4));
  const CollisionSearch search(bodies.a, bodies.b);
  const std::vector<float> weights(bodies.a.model().morph_target_count(), 0.5f);
  ASSERT_TRUE(bodies.a.set_morph_weights(weights));
  EXPECT_TRUE(search.is_stale());
}

TEST(CollisionSearch, CountsDisplacementsByMorphTargets) {
  SearchBodies bodies(test::make_morphing_limb(20, 10, 4), test::make_limb(17, 9, 4));
  const auto work = [&] {
    CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
    search.advance(kUnlimited, bodies.scratch);
    return search.work_done();
  };
  const std::uint64_t at_rest = work();
  const std::vector<float> weights(bodies.a.model().morph_target_count(), 1e-6f);
  ASSERT_TRUE(bodies.a.set_morph_weights(weights));
  EXPECT_GT(work(), at_rest + 100);
}

TEST(CollisionSearch, MovesWithItsPoses) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
  search.advance(100, bodies.scratch);
  const Pose moved_a = std::move(bodies.a);
  CollisionSearch moved = std::move(search);
  EXPECT_FALSE(moved.is_stale());
  moved.advance(kUnlimited, bodies.scratch);
  EXPECT_TRUE(moved.is_complete());
}

using CollisionSearchDeathTest = testing::Test;

TEST(CollisionSearchDeathTest, OnePoseTwiceAborts) {
  SearchBodies bodies = limbs(0.05);
  EXPECT_DEATH(CollisionSearch(bodies.a, bodies.a), "CollisionSearch: `a` and `b`");
}

}  // namespace
}  // namespace pelt
