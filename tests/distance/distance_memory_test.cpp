/// No query allocates after a first one, or in reserved poses.

#include <pelt/distance.hpp>

#include "brute_distance.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

using test::Limbs;
using test::Motion;
using test::Random;
using test::Shape;

/// Runs all queries in the current palettes.
void ask(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& pairs) {
  Distance closest;
  distance(a, b, scratch, closest);
  pairs.clear();
  clearance(a, b, 0.05, scratch, pairs);
  is_within(a, b, 0.5, scratch);
  ClosestPoint point;
  closest_point(a, {1, 2, 3}, scratch, point);
}

TEST(DistanceMemory, DoesNotAllocateOnceWarm) {
  Random random(150);
  Limbs limbs;
  std::vector<Contact> pairs;
  for (int round = 0; round < 20; ++round) {
    const auto palette_a = test::bend_limb(random, 5, 0.3, {});
    const auto palette_b = test::bend_limb(random, 4, 0.3, random.point(1));
    for (int again = 0; again < 2; ++again) {
      ASSERT_TRUE(limbs.a.set_palette(palette_a) && limbs.b.set_palette(palette_b));
      const std::size_t before = test::allocation_count();
      ask(limbs.a, limbs.b, limbs.scratch, pairs);
      if (again == 1) {
        EXPECT_EQ(test::allocation_count(), before);
      }
    }
  }
  EXPECT_GT(test::allocation_count(), 0u) << "the counter must count";
}

TEST(DistanceMemory, DoesNotAllocateOnceReserved) {
  constexpr std::size_t kContacts = 1 << 18;
  test::on_each_instruction_set([](InstructionSet) {
    Random random(151);
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed}) {
      const Shape soup = test::make_soup(random, 200, 20, 4, test::Weights::random);
      Pose a(*build_model(soup.view())), b(a.model());
      Scratch scratch;
      std::vector<Contact> pairs;
      pairs.reserve(kContacts);
      const auto palette_a = test::make_palette(random, 20, motion, 1);
      const auto palette_b = test::make_palette(random, 20, motion, 1);
      a.reserve(), b.reserve(), scratch.reserve(kContacts);
      ASSERT_TRUE(a.set_palette(palette_a) && b.set_palette(palette_b));
      const std::size_t before = test::allocation_count();
      ask(a, b, scratch, pairs);
      EXPECT_EQ(test::allocation_count(), before);
    }
  });
}

}  // namespace
}  // namespace pelt
