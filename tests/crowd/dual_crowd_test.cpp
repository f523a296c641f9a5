/// A crowd of instances with dual quaternion skinning, some with offsets and morph weights, among
/// instances with linear blend skinning.

#include "crowd/test_crowd.hpp"
#include "pose/dual_bodies.hpp"

#include <algorithm>
#include <map>

namespace pelt::test {
namespace {

using Points = std::vector<Vec3>;

/// Instances of three models, and the same as poses at both ends of a step.
class DualCrowd {
 public:
  DualCrowd(Random& random, std::uint32_t count)
      : random_(random),
        shape_(make_dual_shape(random, {.has_morph_targets = true}, 64)),
        caps_(random_caps(random, shape_.rest_positions.size(), 0.03)) {
    SkinnedMeshView view = shape_.view();
    view.offset_caps = caps_;
    const SkinnedModel models[] = {*build_model(view, kDual), *build_model(shape_.view(), kDual),
                                   *build_model(shape_.view())};
    for (std::uint32_t i = 0; i < count; ++i) {
      const SkinnedModel& model = models[i % 3];
      EXPECT_EQ(crowd.add(model), i);
      from.emplace_back(model);
      to.emplace_back(model);
    }
    for (const SkinnedModel& model : models)
      filters.emplace(&model.detail(), *build_self_filter(model, {.rings = 1}));
    offsets_[0].resize(count);
    offsets_[1].resize(count);
  }

  /// Moves all instances but every fifth.
  void step() {
    crowd.begin_step();
    end_ = 1 - end_;
    for (std::uint32_t i = 0; i < to.size(); ++i) {
      if (i % 5 == 4) continue;
      std::swap(from[i], to[i]);
      move(i);
    }
  }

  const SelfFilter* filter_of(std::uint32_t i) const {
    return &filters.at(&crowd.model(i).detail());
  }

  std::vector<CrowdContact> expected() {
    std::vector<CrowdContact> all;
    std::vector<Contact> contacts;
    for (std::uint32_t a = 0; a < to.size(); ++a)
      for (std::uint32_t b = a; b < to.size(); ++b) {
        contacts.clear();
        if (a == b)
          self_collide(to[a], *filter_of(a), scratch_, contacts);
        else
          collide(to[a], to[b], scratch_, contacts);
        for (const Contact& c : contacts) all.push_back({a, b, c.triangle_a, c.triangle_b});
      }
    return all;
  }

  std::vector<CrowdMovingContact> expected_moving() {
    std::vector<CrowdMovingContact> all;
    std::vector<MovingContact> contacts;
    for (std::uint32_t a = 0; a < to.size(); ++a)
      for (std::uint32_t b = a + 1; b < to.size(); ++b) {
        contacts.clear();
        const pelt::Motion move_a = {is_moving(a) ? from[a] : to[a], to[a]};
        const pelt::Motion move_b = {is_moving(b) ? from[b] : to[b], to[b]};
        collide_moving(move_a, move_b, scratch_, contacts);
        for (const MovingContact& contact : contacts) all.push_back({a, b, contact});
      }
    return all;
  }

  Crowd crowd;
  std::vector<Pose> from, to;
  std::map<const detail::Model*, SelfFilter> filters;
  int as_dual_quaternions = 0, as_matrices = 0;

 private:
  static bool is_moving(std::uint32_t i) { return i % 5 != 4; }

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

  void move(std::uint32_t i) {
    set_joints(i);
    const std::vector<float> weights = make_morph_weights(random_, 3, Morphing::some);
    ASSERT_TRUE(to[i].set_morph_weights(weights));
    ASSERT_TRUE(crowd.set_morph_weights(i, weights));
    if (i % 3 != 0) return;
    Points& offsets = offsets_[end_][i];
    offsets = random_offsets(random_, caps_);
    ASSERT_TRUE(to[i].set_offsets(offsets));
    ASSERT_TRUE(crowd.set_offsets(i, offsets));
  }

  Random& random_;
  Shape shape_;
  Caps caps_;
  std::vector<Points> offsets_[2];  // of both ends, because poses borrow them
  std::size_t end_ = 0;
  Scratch scratch_;
};

TEST(DualCrowd, EqualsAllPairsOneByOneWithAnyNumberOfThreads) {
  Random random(1910);
  DualCrowd crowd(random, 10);
  std::size_t contacts = 0, moving = 0;
  for (int round = 0; round < 4; ++round) {
    crowd.step();
    const auto expected = crowd.expected();
    const auto expected_moving = crowd.expected_moving();
    for (const std::uint32_t threads : {1u, 3u}) {
      std::vector<CrowdContact> found;
      crowd.crowd.collide(found, {.threads = threads, .self_filter = [&](std::uint32_t i) {
                                    return crowd.filter_of(i);
                                  }});
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected) << "round " << round;
      std::vector<CrowdMovingContact> found_moving;
      crowd.crowd.collide_moving(found_moving, {.threads = threads});
      ASSERT_EQ(found_moving, expected_moving) << "round " << round;
    }
    contacts += expected.size();
    moving += expected_moving.size();
  }
  std::printf("%zu contacts, %zu moving contacts, %d palettes of dual quaternions, %d others\n",
              contacts, moving, crowd.as_dual_quaternions, crowd.as_matrices);
  EXPECT_GT(contacts, 1000u);
  EXPECT_GT(moving, 3000u);
  EXPECT_GT(crowd.as_dual_quaternions, 8);
  EXPECT_GT(crowd.as_matrices, 8);
}

/// The first change of a step saves the pose before it.
TEST(DualCrowd, DualQuaternionsBeginTheMotionOfAnInstance) {
  Random random(1911);
  const Shape shape = make_limb(16, 8, kDualJoints);
  const SkinnedModel model = *build_model(shape.view(), kDual);
  Crowd crowd;
  ASSERT_EQ(crowd.add(model), 0u);
  ASSERT_EQ(crowd.add(model), 1u);
  const auto palette = [](float x) { return twist_limb(kDualJoints, 0.5, {x, 0, 0}); };
  ASSERT_TRUE(crowd.set_dual_quaternions(0, signed_dual_quaternions(random, palette(-1))));
  crowd.begin_step();
  ASSERT_TRUE(crowd.set_dual_quaternions(0, signed_dual_quaternions(random, palette(1))));
  std::vector<CrowdContact> contacts;
  crowd.collide(contacts);
  EXPECT_EQ(contacts.size(), 0u);
  std::vector<CrowdMovingContact> moving;
  crowd.collide_moving(moving);
  EXPECT_GT(moving.size(), 100u);
}

TEST(DualCrowd, DualQuaternionsMoveTheBoxOfAnInstance) {
  Random random(1913);
  const Shape shape = make_limb(16, 8, kDualJoints);
  const SkinnedModel model = *build_model(shape.view(), kDual);
  Crowd crowd;
  ASSERT_EQ(crowd.add(model), 0u);
  ASSERT_EQ(crowd.add(model), 1u);
  ASSERT_TRUE(crowd.set_palette(0, twist_limb(kDualJoints, 0.5, {9, 0, 0})));
  std::vector<CrowdContact> contacts;
  EXPECT_EQ(crowd.collide(contacts).candidate_pairs, 0u);
  const auto back = signed_dual_quaternions(random, twist_limb(kDualJoints, 0.5, {}));
  ASSERT_TRUE(crowd.set_dual_quaternions(0, back));
  EXPECT_EQ(crowd.collide(contacts).candidate_pairs, 1u);
  EXPECT_GT(contacts.size(), 100u);
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
