/// Given vertices, offsets and dual quaternions of instances. That crowds of them find what pairs
/// of poses find is part of the contract of queries (query/query_contract_test.cpp).

#include "support/dual_bodies.hpp"

#include <pelt/crowd.hpp>

namespace pelt::test {
namespace {

/// Two limbs in the same place.
struct TwoLimbs {
  TwoLimbs() {
    const SkinnedModel model = *build_model(make_limb(16, 8, kDualJoints).view(), kDual);
    EXPECT_EQ(crowd.add(model), 0u);
    EXPECT_EQ(crowd.add(model), 1u);
  }

  Crowd crowd;
  std::vector<CrowdContact> contacts;
};

/// The first change of a step saves the pose before it.
TEST(DualCrowd, DualQuaternionsBeginTheMotionOfAnInstance) {
  Random random(1911);
  TwoLimbs limbs;
  const auto palette = [](float x) { return twist_limb(kDualJoints, 0.5, {x, 0, 0}); };
  ASSERT_TRUE(limbs.crowd.set_dual_quaternions(0, signed_dual_quaternions(random, palette(-1))));
  limbs.crowd.begin_step();
  ASSERT_TRUE(limbs.crowd.set_dual_quaternions(0, signed_dual_quaternions(random, palette(1))));
  limbs.crowd.collide(limbs.contacts);
  EXPECT_EQ(limbs.contacts.size(), 0u);
  std::vector<CrowdMovingContact> moving;
  limbs.crowd.collide(moving);
  EXPECT_GT(moving.size(), 100u);
}

/// Both ends are set at once, from any pose, and a wrong end leaves the instance where it is.
TEST(DualCrowd, SetsDualQuaternionsOfBothEndsOfAStep) {
  Random random(1914);
  TwoLimbs limbs;
  const auto duals = [&](float x, double turns) {
    return signed_dual_quaternions(random, twist_limb(kDualJoints, turns, {x, 0, 0}));
  };
  const std::vector<float> from = duals(-1, 0.5), to = duals(1, 0.2);
  const auto set = [&](const std::vector<float>& first, const std::vector<float>& last) {
    return limbs.crowd.set_motion_dual_quaternions(0, first, last);
  };
  ASSERT_TRUE(set(from, to));
  Pose still(limbs.crowd.model(1)), start(still.model()), end(still.model());
  ASSERT_TRUE(start.set_dual_quaternions(from) && end.set_dual_quaternions(to));
  Scratch scratch;
  std::vector<MovingContact> expected;
  Pose also_still(still.model());
  collide({start, end}, {still, also_still}, scratch, expected);
  std::vector<CrowdMovingContact> moving;
  limbs.crowd.collide(moving);
  ASSERT_EQ(moving.size(), expected.size());
  for (std::size_t i = 0; i < moving.size(); ++i) EXPECT_EQ(moving[i].moving, expected[i]);
  EXPECT_GT(moving.size(), 100u);

  ASSERT_TRUE(set(from, from));
  std::vector<float> wrong = to;
  wrong[0] += 2;
  EXPECT_FALSE(set(wrong, to));
  EXPECT_FALSE(set(to, wrong));
  moving.clear();
  limbs.crowd.collide(moving);
  EXPECT_EQ(moving.size(), 0u);
}

TEST(DualCrowd, DualQuaternionsMoveTheBoxOfAnInstance) {
  Random random(1913);
  TwoLimbs limbs;
  ASSERT_TRUE(limbs.crowd.set_palette(0, twist_limb(kDualJoints, 0.5, {9, 0, 0})));
  EXPECT_EQ(limbs.crowd.collide(limbs.contacts).candidate_pairs, 0u);
  const auto back = signed_dual_quaternions(random, twist_limb(kDualJoints, 0.5, {}));
  ASSERT_TRUE(limbs.crowd.set_dual_quaternions(0, back));
  EXPECT_EQ(limbs.crowd.collide(limbs.contacts).candidate_pairs, 1u);
  EXPECT_GT(limbs.contacts.size(), 100u);
}

TEST(DualCrowd, RefusesWhatAPoseRefuses) {
  Random random(1912);
  const Shape shape = make_limb(16, 8, kDualJoints);
  Crowd crowd;
  const std::uint32_t linear = crowd.add(*build_model(shape.view()));
  const std::uint32_t dual = crowd.add(*build_model(shape.view(), kDual));
  const auto duals = signed_dual_quaternions(random, twist_limb(kDualJoints, 0.5, {9, 0, 0}));
  const auto expect_refused = [&](std::uint32_t instance, const std::vector<float>& floats) {
    Pose pose(crowd.model(instance));
    const Result<void> expected = pose.set_dual_quaternions(floats);
    const Result<void> refused = crowd.set_dual_quaternions(instance, floats);
    ASSERT_FALSE(expected);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, expected.error().message);
  };
  expect_refused(linear, duals);
  expect_refused(dual, std::vector<float>(8));
  std::vector<float> long_rotation = duals;
  long_rotation[0] += 2;
  expect_refused(dual, long_rotation);
  std::vector<CrowdContact> contacts;
  crowd.collide(contacts);
  EXPECT_GT(contacts.size(), 100u);  // both are still where they were
}

TEST(GivenCrowd, RefusesWhatAPoseRefuses) {
  Random random(1901);
  const Shape shape = make_limb(16, 8, 4);
  Crowd crowd;
  const std::uint32_t instance = crowd.add(*build_model(shape.view()));
  const std::size_t bytes = crowd.memory_bytes();
  EXPECT_FALSE(crowd.set_vertices(instance, std::vector<Vec3>(3)));
  EXPECT_FALSE(crowd.set_offsets(instance, std::vector<Vec3>(shape.rest_positions.size())));
  EXPECT_EQ(crowd.memory_bytes(), bytes);
  EXPECT_TRUE(crowd.set_vertices(instance, shape.rest_positions));
  EXPECT_GT(crowd.memory_bytes(), bytes + 16 * shape.rest_positions.size());
}

}  // namespace
}  // namespace pelt::test
