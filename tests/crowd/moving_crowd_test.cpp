/// A crowd in motion, against every pair of motions one by one.

#include <pelt/config.hpp>
#include <pelt/self.hpp>

#include "crowd/test_crowd.hpp"

#include <algorithm>
#include <tuple>

namespace pelt::test {
namespace {

/// A crowd, and the same instances as poses at both ends of a step.
struct MovingCrowd {
  MovingCrowd(Random& random, std::uint32_t count) : crowd(make_mixed_crowd(random, count, 1)) {
    for (const Pose& pose : crowd.poses) {
      from.emplace_back(pose.model());
      to.emplace_back(pose.model());
    }
  }

  /// Moves two of three instances; the others stand still.
  void step(Random& random) {
    crowd.crowd.begin_step();
    for (std::uint32_t i = 0; i < from.size(); ++i) {
      const std::uint32_t model = model_of(crowd, i);
      const std::vector<Matrix4> first = palette_for(random, model, 1);
      ASSERT_TRUE(from[i].set_palette(last.size() > i ? last[i] : first));
      if (last.size() <= i) {
        last.push_back(first);
        ASSERT_TRUE(crowd.crowd.set_motion(i, std::span<const Matrix4>(first),
                                           std::span<const Matrix4>(first)));
      }
      if (i % 3 != 2) {
        last[i] = palette_for(random, model, 1);
        ASSERT_TRUE(crowd.crowd.set_palette(i, last[i]));
      }
      ASSERT_TRUE(to[i].set_palette(last[i]));
    }
  }

  std::vector<CrowdMovingContact> expected(const MovingOptions& options = {}) {
    std::vector<CrowdMovingContact> all;
    Scratch scratch;
    for (std::uint32_t a = 0; a < from.size(); ++a)
      for (std::uint32_t b = a + 1; b < from.size(); ++b) {
        std::vector<MovingContact> contacts;
        pelt::collide({from[a], to[a]}, {from[b], to[b]}, scratch, contacts, options);
        for (const MovingContact& contact : contacts) all.push_back({a, b, contact});
      }
    return all;
  }

  std::vector<CrowdMovingContact> contacts(std::uint32_t threads,
                                           const MovingOptions& options = {}) {
    std::vector<CrowdMovingContact> found;
    crowd.crowd.collide(found, {.threads = threads}, options);
    return found;
  }

  TestCrowd crowd;
  std::vector<Pose> from, to;
  std::vector<std::vector<Matrix4>> last;
};

TEST(MovingCrowd, EqualsAllPairsOneByOneWithAnyTargetAndNumberOfThreads) {
  Random random(1841);
  const InstructionSet fastest = active_instruction_set();
  MovingCrowd crowd(random, 6);
  std::size_t contacts = 0, later = 0, untimed_contacts = 0;
  for (int round = 0; round < 3; ++round) {
    crowd.step(random);
    const auto expected = crowd.expected();
    ASSERT_EQ(crowd.contacts(1), expected) << "round " << round;
    const MovingOptions untimed = {.leave_out_start = true, .times = false};
    const auto expected_untimed = crowd.expected(untimed);
    for (const InstructionSet set : available_instruction_sets())
      for (const std::uint32_t threads : {1u, 3u}) {
        ASSERT_TRUE(set_active_instruction_set(set));
        ASSERT_EQ(crowd.contacts(threads, untimed), expected_untimed) << "round " << round;
      }
    ASSERT_TRUE(set_active_instruction_set(fastest));
    untimed_contacts += expected_untimed.size();
    contacts += expected.size();
    for (const CrowdMovingContact& c : expected) later += !c.moving.at_start;
  }
  EXPECT_GT(contacts, 1000u);
  EXPECT_GT(later, 500u);
  EXPECT_EQ(untimed_contacts, later);
}

/// Without a step, and with one in which nothing moves, only what touches now is found.
TEST(MovingCrowd, StandsStillUntilItIsMoved) {
  Random random(1842);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto now = crowd.contacts();
  ASSERT_GT(now.size(), 100u);
  for (int step = 0; step < 2; ++step) {
    std::vector<CrowdMovingContact> moving;
    crowd.crowd.collide(moving);
    ASSERT_EQ(moving.size(), now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
      EXPECT_TRUE(moving[i].moving.at_start && moving[i].instance_a == now[i].instance_a &&
                  moving[i].moving.contact == (Contact{now[i].triangle_a, now[i].triangle_b}));
    crowd.crowd.begin_step();
  }
}

TEST(MovingCrowd, StandsStillAfterARefusedMotion) {
  Random random(1843);
  TestCrowd crowd = make_mixed_crowd(random, 2, 0.1);
  std::vector<Matrix4> good(crowd.models[model_of(crowd, 0)].joint_count());
  std::vector<Matrix4> bad = good;
  bad[0].m[5] = std::numeric_limits<float>::quiet_NaN();
  const auto set = [&](const std::vector<Matrix4>& from, const std::vector<Matrix4>& to) {
    return crowd.crowd.set_motion(0, std::span<const Matrix4>(from), std::span<const Matrix4>(to));
  };
  const auto now = crowd.contacts();
  EXPECT_FALSE(set(bad, good));
  EXPECT_FALSE(set(good, bad));
  EXPECT_EQ(crowd.contacts(), now);
  std::vector<CrowdMovingContact> moving;
  crowd.crowd.collide(moving);
  EXPECT_EQ(moving.size(), now.size());
}

TEST(MovingCrowd, MovesMorphWeights) {
  const Shape shape = make_morphing_limb(12, 8, 3);
  const SkinnedModel model = *build_model(shape.view());
  Crowd crowd;
  Pose from[2] = {Pose(model), Pose(model)}, to[2] = {Pose(model), Pose(model)};
  const std::vector<float> first = {0, 0, 0}, second = {4, 0, 0};
  for (std::uint32_t i = 0; i < 2; ++i) {
    crowd.add(model);
    std::vector<Matrix4> palette(3);
    for (Matrix4& m : palette) m.m[12] = 0.22f * static_cast<float>(i);
    ASSERT_TRUE(crowd.set_palette(i, palette));
    ASSERT_TRUE(crowd.set_morph_weights(i, first));
    ASSERT_TRUE(from[i].set_palette(palette) && from[i].set_morph_weights(first));
    ASSERT_TRUE(to[i].set_palette(palette) && to[i].set_morph_weights(i == 0 ? second : first));
  }
  crowd.begin_step();
  ASSERT_TRUE(crowd.set_morph_weights(0, second));
  std::vector<CrowdMovingContact> found;
  crowd.collide(found);
  Scratch scratch;
  std::vector<MovingContact> expected;
  pelt::collide({from[0], to[0]}, {from[1], to[1]}, scratch, expected);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].moving, expected[i]);
  std::vector<CrowdContact> at_end;
  crowd.collide(at_end);
  EXPECT_GT(found.size(), at_end.size());
}

TEST(MovingCrowd, TestsInstancesAgainstThemselves) {
  Random random(1849);
  MovingCrowd crowd(random, 6);
  std::vector<SelfFilter> filters;
  for (const Pose& pose : crowd.from) filters.push_back(*build_self_filter(pose.model()));
  CrowdOptions options;
  options.self_filter = [&](std::uint32_t i) { return i == 4 ? nullptr : &filters[i]; };
  std::size_t own = 0;
  for (int round = 0; round < 3; ++round) {
    crowd.step(random);
    auto expected = crowd.expected();
    Scratch scratch;
    for (std::uint32_t i = 0; i < filters.size(); ++i) {
      if (i == 4) continue;
      std::vector<MovingContact> contacts;
      self_collide({crowd.from[i], crowd.to[i]}, filters[i], scratch, contacts);
      for (const MovingContact& contact : contacts) expected.push_back({i, i, contact});
      own += contacts.size();
    }
    std::sort(expected.begin(), expected.end(), [](const auto& x, const auto& y) {
      return std::tie(x.instance_a, x.instance_b, x.moving.contact) <
             std::tie(y.instance_a, y.instance_b, y.moving.contact);
    });
    for (const std::uint32_t threads : {1u, 3u}) {
      options.threads = threads;
      std::vector<CrowdMovingContact> found;
      const CrowdStats stats = crowd.crowd.crowd.collide(found, options);
      ASSERT_EQ(found, expected) << "round " << round;
      EXPECT_EQ(stats.self_tests, filters.size() - 1);
    }
  }
  EXPECT_GT(own, 100u);
}

}  // namespace
}  // namespace pelt::test
