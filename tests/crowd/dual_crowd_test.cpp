/// A crowd of instances with dual quaternion skinning, some with offsets and morph weights, among
/// instances with linear blend skinning.

#include "crowd/posed_crowd.hpp"
#include "pose/dual_bodies.hpp"

namespace pelt::test {
namespace {

/// Instances of three models.
class DualCrowd final : public PosedCrowd {
 public:
  DualCrowd(Random& random, const Shape& shape, const Caps& caps, std::uint32_t count)
      : PosedCrowd(models_of(shape, caps), count, 5), random_(random), caps_(caps) {}

  int as_dual_quaternions = 0, as_matrices = 0;

 private:
  /// With dual quaternions and caps, with dual quaternions, and with linear blend skinning.
  static std::vector<SkinnedModel> models_of(const Shape& shape, const Caps& caps) {
    SkinnedMeshView view = shape.view();
    view.offset_caps = caps;
    return {*build_model(view, kDual), *build_model(shape.view(), kDual),
            *build_model(shape.view())};
  }

  /// Matrices are those of the dual quaternions up to rounding, so both sides get the same form.
  void set_joints(std::uint32_t i) {
    const Turns turns = random_.chance(0.7) ? Turns::small : Turns::antipodal;
    const auto palette = turn_limb(random_, turns, random_.point(0.3));
    if (i % 3 != 2 && random_.chance(0.6)) {
      const std::vector<float> duals = signed_dual_quaternions(random_, palette);
      ASSERT_TRUE(to[i].set_dual_quaternions(duals));
      ASSERT_TRUE(crowd.set_dual_quaternions(i, duals));
      ++as_dual_quaternions;
    } else {
      ASSERT_TRUE(to[i].set_palette(palette));
      ASSERT_TRUE(crowd.set_palette(i, palette));
      ++as_matrices;
    }
  }

  void move(std::uint32_t i) override {
    set_joints(i);
    const std::vector<float> weights = make_morph_weights(random_, 3, Morphing::some);
    ASSERT_TRUE(to[i].set_morph_weights(weights));
    ASSERT_TRUE(crowd.set_morph_weights(i, weights));
    if (i % 3 == 0) set_offsets(i, random_offsets(random_, caps_));
  }

  Random& random_;
  const Caps& caps_;
};

TEST(DualCrowd, EqualsAllPairsOneByOneWithAnyNumberOfThreads) {
  Random random(1910);
  const Shape shape = make_dual_shape(random, {.has_morph_targets = true}, 64);
  const Caps caps = random_caps(random, shape.rest_positions.size(), 0.03);
  DualCrowd crowd(random, shape, caps, 10);
  for (int round = 0; round < 4; ++round) {
    crowd.step();
    crowd.expect_all_pairs();
    if (HasFatalFailure()) return;
  }
  std::printf("%zu contacts, %zu moving contacts, %d palettes of dual quaternions, %d others\n",
              crowd.contacts, crowd.moving, crowd.as_dual_quaternions, crowd.as_matrices);
  EXPECT_GT(crowd.contacts, 1000u);
  EXPECT_GT(crowd.moving, 3000u);
  EXPECT_GT(crowd.as_dual_quaternions, 8);
  EXPECT_GT(crowd.as_matrices, 8);
}

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

}  // namespace
}  // namespace pelt::test
