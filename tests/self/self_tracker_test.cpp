#include <pelt/self.hpp>

#include "body.hpp"
#include "support/dual_bodies.hpp"
#include "support/instruction_sets.hpp"
#include "support/pinned_shapes.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pelt::test {
namespace {

/// Compares a tracker with queries that remember nothing, frame after frame.
class Tracked {
 public:
  explicit Tracked(const Shape& shape, const SelfFilterOptions& options = {},
                   const ModelOptions& how = {})
      : body(shape, options, how), tracker(body.filter) {}

  void expect_same(const std::vector<Matrix4>& palette) {
    ASSERT_TRUE(body.pose.set_palette(palette));
    std::vector<Contact> expected, found;
    const SelfStats plain = self_collide(body.pose, body.filter, body.scratch, expected);
    const SelfStats tracked = self_collide(body.pose, tracker, body.scratch, found);
    ASSERT_EQ(found, expected) << "frame " << frames;
    EXPECT_EQ(tracked.left_out.total(), plain.left_out.total());
    EXPECT_EQ(tracked.cut_short, plain.cut_short);
    plain_pairs += plain.triangle_pairs, tracked_pairs += tracked.triangle_pairs;
    changes += frames > 0 && found != last;
    contacts += found.size();
    last = std::move(found);
    ++frames;
  }

  Body body;
  SelfTracker tracker;
  std::vector<Contact> last;
  int frames = 0, changes = 0;
  std::size_t contacts = 0;
  std::uint64_t plain_pairs = 0, tracked_pairs = 0;
};

TEST(SelfTracker, EqualsSelfCollideOnBendingLimbs) {
  on_each_instruction_set([](InstructionSet) {
    Tracked tracked(make_limb(40, 9, 6));
    Random random(920);
    double angle = 0.1;
    Vec3 placement;
    for (int frame = 0; frame < 300; ++frame) {
      angle = std::clamp(angle + random.uniform(-0.02, 0.03), 0.0, 1.6);
      const Vec3 way = random.point(0.3);
      placement = {placement.x + way.x, placement.y + way.y, placement.z + way.z};
      Random axis(921);
      ASSERT_NO_FATAL_FAILURE(tracked.expect_same(bend_limb(axis, 6, angle, placement)));
    }
    EXPECT_GT(tracked.changes, 50);
    EXPECT_LT(tracked.changes, 299);
    EXPECT_LT(tracked.tracked_pairs, 2 * tracked.plain_pairs);
  });
}

/// Positions on a torus of `rings` times `sides` vertices.
std::vector<Vec3> torus_positions(std::uint32_t rings, std::uint32_t sides) {
  std::vector<Vec3> positions;
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double a = 2 * M_PI * r / rings, b = 2 * M_PI * s / sides, radius = 3 + std::cos(b);
      positions.push_back({static_cast<float>(radius * std::cos(a)),
                           static_cast<float>(radius * std::sin(a)),
                           static_cast<float>(std::sin(b))});
    }
  return positions;
}

/// Every vertex moves a little in each frame, until the surface is crumpled. Slack that is too
/// large by one step shows as a missing contact.
TEST(SelfTracker, EqualsSelfCollideWhileASurfaceCrumplesSlowly) {
  on_each_instruction_set([](InstructionSet) {
    Random random(922);
    int changes = 0, frames = 0;
    std::uint64_t plain = 0, with_tracker = 0;
    for (int round = 0; round < 6; ++round) {
      const std::uint32_t rings = 24, sides = 12;
      Tracked tracked(make_pinned(rings * sides, torus(rings, sides)));
      std::vector<Vec3> positions = torus_positions(rings, sides), speeds;
      for (std::size_t v = 0; v < positions.size(); ++v)
        speeds.push_back(random.point(round % 3 == 0 ? 0.01 : round % 3 == 1 ? 0.003 : 0.03));
      for (int frame = 0; frame < 60; ++frame) {
        for (std::size_t v = 0; v < positions.size(); ++v) {
          positions[v] = {positions[v].x + speeds[v].x, positions[v].y + speeds[v].y,
                          positions[v].z + speeds[v].z};
          if (frame % 20 == 19 && round > 3) positions[v].x = -positions[v].x;  // a jump
        }
        ASSERT_NO_FATAL_FAILURE(tracked.expect_same(pin(positions)));
      }
      changes += tracked.changes, frames += tracked.frames;
      plain += tracked.plain_pairs, with_tracker += tracked.tracked_pairs;
    }
    EXPECT_GT(changes, frames / 4);
    EXPECT_LT(changes, frames * 9 / 10);
    EXPECT_LT(with_tracker, 2 * plain);
  });
}

/// A fan whose vertices move until it folds or overlaps itself.
TEST(SelfTracker, EqualsSelfCollideOnFansThatFoldSlowly) {
  Random random(923);
  int changes = 0;
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t size = 3 + random.index(8);
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < size; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % size});
    Tracked tracked(make_pinned(size + 1, triangles));
    std::vector<Vec3> positions = {{0, 0, 0}}, speeds;
    for (std::uint32_t i = 0; i < size; ++i) {
      const double turn = 2 * M_PI * i / size;
      positions.push_back({static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)),
                           random.uniformf(-0.2, 0.2)});
    }
    for (std::size_t v = 0; v < positions.size(); ++v) speeds.push_back(random.point(0.04));
    for (int frame = 0; frame < 60; ++frame) {
      for (std::size_t v = 0; v < positions.size(); ++v)
        positions[v] = {positions[v].x + speeds[v].x, positions[v].y + speeds[v].y,
                        positions[v].z + speeds[v].z};
      ASSERT_NO_FATAL_FAILURE(tracked.expect_same(pin(positions)));
    }
    changes += tracked.changes;
  }
  EXPECT_GT(changes, 200);
}

/// Any palette may follow any other, also one that mirrors, collapses or moves far away.
TEST(SelfTracker, EqualsSelfCollideAfterJumps) {
  on_each_instruction_set([](InstructionSet) {
    Random random(924);
    std::size_t contacts = 0;
    for (const std::uint32_t influences : {1u, 4u}) {
      Tracked tracked(make_soup(random, 200, 6, influences, Weights::random), {.rings = 1});
      for (int round = 0; round < 4; ++round)
        for (const Motion motion :
             {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away}) {
          std::vector<Matrix4> palette = make_palette(random, 6, motion, 1);
          for (int frame = 0; frame < 4; ++frame) {
            ASSERT_NO_FATAL_FAILURE(tracked.expect_same(palette));
            for (Matrix4& joint : palette) joint.m[12 + random.index(3)] += 0.001f;
          }
        }
      contacts += tracked.contacts;
    }
    EXPECT_GT(contacts, 4'000u);
  });
}

TEST(SelfTracker, EqualsSelfCollideOnDualQuaternionsThatBendSlowly) {
  Random random(152);
  int changes = 0, frames = 0;
  for (std::uint32_t influences = 1; influences <= 8; ++influences) {
    const DualKind kind = {Turns::small, influences, influences % 2 == 0};
    Tracked tracked(make_dual_shape(random, kind, 100), {}, kDual);
    const Random axis = random;
    for (int frame = 0; frame < 40; ++frame) {
      Random same = axis;
      ASSERT_NO_FATAL_FAILURE(tracked.expect_same(bend_limb(same, kDualJoints, 0.02 * frame, {})));
    }
    changes += tracked.changes, frames += tracked.frames;
  }
  EXPECT_GT(changes, frames / 4);
}

TEST(SelfTracker, KeepsItsAnswersWithLimits) {
  Tracked tracked(make_limb(40, 9, 6));
  Random random(925);
  int cut = 0;
  for (int frame = 0; frame < 120; ++frame) {
    Random axis(926);
    const auto palette = bend_limb(axis, 6, 1.0 + 0.005 * frame, {});
    if (frame % 3 > 0) {
      ASSERT_TRUE(tracked.body.pose.set_palette(palette));
      const auto all =
          self_contacts_of(tracked.body.pose, tracked.body.filter, tracked.body.scratch);
      const std::uint32_t limit = random.index(12);
      std::vector<Contact> found;
      const SelfStats stats = self_collide(tracked.body.pose, tracked.tracker, tracked.body.scratch,
                                           found, {.max_contacts = limit});
      EXPECT_EQ(found.size(), std::min<std::size_t>(limit, all.size()));
      EXPECT_TRUE(std::includes(all.begin(), all.end(), found.begin(), found.end()));
      EXPECT_TRUE(stats.cut_short || all.size() <= limit);
      cut += stats.cut_short;
    }
    ASSERT_NO_FATAL_FAILURE(tracked.expect_same(palette));
  }
  EXPECT_GT(cut, 20);
}

TEST(SelfTracker, TestsFewPairsOfABodyThatMovesAsAWhole) {
  Tracked tracked(make_limb(60, 24, 3));
  Random random(927);
  const std::vector<Matrix4> bent = bend_limb(random, 3, 0.3, {});
  const auto pairs_at = [&](const Vec3& placement) {
    Random axis(927);
    const std::uint64_t before = tracked.tracked_pairs;
    tracked.expect_same(bend_limb(axis, 3, 0.3, placement));
    return tracked.tracked_pairs - before;
  };
  const std::uint64_t first = pairs_at({});
  EXPECT_GT(first, 100u);
  EXPECT_LT(pairs_at({0.5f, 0, 0}), first / 4);
  EXPECT_LT(pairs_at({0.5f, 1, 0.25f}), first / 4);
}

/// A tracker rests where every frame is a jump.
TEST(SelfTracker, AddsLittleWorkWhereNothingCanBeSkipped) {
  Random random(929);
  Tracked tracked(make_soup(random, 600, 6, 4, Weights::random));
  for (int frame = 0; frame < 100; ++frame) {
    ASSERT_NO_FATAL_FAILURE(tracked.expect_same(make_palette(random, 6, Motion::rigid, 1)));
  }
  EXPECT_GT(tracked.plain_pairs, 10'000u);
  EXPECT_LT(tracked.tracked_pairs, tracked.plain_pairs * 11 / 10);
}

TEST(SelfTracker, CountsItsMemory) {
  const Shape shape = make_limb(120, 24, 6);
  Tracked tracked(shape);
  EXPECT_GT(tracked.tracker.memory_bytes(), 10 * shape.triangles.size());
  EXPECT_LT(tracked.tracker.memory_bytes(), 40 * shape.triangles.size());
}

TEST(SelfTracker, RefusesThePoseOfAnotherModel) {
  Tracked tracked(make_limb(12, 8, 3));
  Body other(make_limb(12, 8, 3));
  std::vector<Contact> contacts;
  EXPECT_DEATH(self_collide(other.pose, tracked.tracker, other.scratch, contacts),
               "self_collide: the tracker is of another model");
}

}  // namespace
}  // namespace pelt::test
