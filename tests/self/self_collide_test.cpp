#include <pelt/self_collide.hpp>

#include "self_brute_force.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using test::brute_force_self;
using test::Motion;
using test::Random;
using test::self_contacts_of;
using test::Shape;
using test::Weights;

/// A pose and its filter.
struct Body {
  explicit Body(const Shape& s)
      : shape(s), pose(*build_model(s.view())), filter(*build_self_filter(pose.model())) {}

  Shape shape;
  Pose pose;
  SelfFilter filter;
  Scratch scratch;
};

/// Bends a limb until it folds onto itself.
void fold(Random& random, Body& body) {
  ASSERT_TRUE(body.pose.set_palette(
      test::bend_limb(random, body.shape.joint_count, random.uniform(0.2, 1.6), {})));
}

TEST(SelfCollide, EqualsBruteForceOnFoldedLimbs) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(900);
    Body body(test::make_limb(30, 9, 6));
    int touching = 0, apart = 0;
    for (int round = 0; round < 40; ++round) {
      fold(random, body);
      const auto expected = brute_force_self(body.shape, body.pose);
      ASSERT_EQ(self_contacts_of(body.pose, body.filter, body.scratch), expected)
          << "round " << round;
      ASSERT_EQ(self_intersects(body.pose, body.filter, body.scratch).answer, !expected.empty());
      ++(expected.empty() ? apart : touching);
    }
    EXPECT_GT(touching, 10);
    EXPECT_GT(apart, 1);
  });
}

TEST(SelfCollide, EqualsBruteForceOnSoupsUnderAnyAffineJoints) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(901);
    std::size_t contacts = 0;
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
        for (const std::uint32_t influences : {1u, 4u}) {
          Body body(test::make_soup(random, 150, 6, influences, weights));
          ASSERT_TRUE(body.pose.set_palette(test::make_palette(random, 6, motion, 1)));
          const auto expected = brute_force_self(body.shape, body.pose);
          ASSERT_EQ(self_contacts_of(body.pose, body.filter, body.scratch), expected);
          contacts += expected.size();
        }
    EXPECT_GT(contacts, 10'000u);
  });
}

}  // namespace
}  // namespace pelt
