/// The query of two moving characters against the exact test of all pairs of their triangles.

#include <pelt/motion.hpp>
#include <pelt/self.hpp>

#include "base/bits.hpp"
#include "base/hash.hpp"
#include "collide/moving_bodies.hpp"
#include "motion/meeting_order.hpp"
#include "scenes/creature.hpp"
#include "support/animated_character.hpp"
#include "support/closed_shapes.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace pelt::test {
namespace {

std::vector<Contact> pairs_of(const std::vector<MovingContact>& contacts) {
  std::vector<Contact> pairs;
  for (const MovingContact& c : contacts) pairs.push_back(c.contact);
  return pairs;
}

TEST(CollideMoving, OfCharactersThatStandStillIsCollide) {
  Random random(1804);
  Limbs limbs;
  limbs.move(random, 0.1);
  Scratch scratch;
  std::vector<Contact> expected;
  collide(limbs.a.from, limbs.b.from, scratch, expected);
  ASSERT_GT(expected.size(), 20u);
  std::vector<MovingContact> found;
  collide({limbs.a.from, limbs.a.from}, {limbs.b.from, limbs.b.from}, scratch, found);
  EXPECT_EQ(pairs_of(found), expected);
  for (const MovingContact& c : found) EXPECT_TRUE(c.at_start && c.time == 0);
}

TEST(CollideMoving, ContainsTheContactsOfBothEnds) {
  Random random(1805);
  Limbs limbs;
  Scratch scratch;
  std::size_t at_ends = 0;
  for (int round = 0; round < 20; ++round) {
    limbs.move(random, 0.3);
    const auto found = pairs_of(contacts_of(limbs.a, limbs.b));
    for (const auto& [a, b] :
         {std::pair(&limbs.a.from, &limbs.b.from), std::pair(&limbs.a.to, &limbs.b.to)}) {
      std::vector<Contact> end;
      collide(*a, *b, scratch, end);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), end.begin(), end.end()));
      at_ends += end.size();
    }
  }
  EXPECT_GT(at_ends, 200u);
}

TEST(CollideMoving, FindsTheSamePairsBackwards) {
  Random random(1806);
  Limbs limbs;
  Scratch scratch;
  std::size_t seen = 0;
  for (int round = 0; round < 20; ++round) {
    limbs.move(random, 0.3);
    const auto pairs = pairs_of(contacts_of(limbs.a, limbs.b));
    std::vector<MovingContact> backwards;
    collide({limbs.a.to, limbs.a.from}, {limbs.b.to, limbs.b.from}, scratch, backwards);
    EXPECT_EQ(pairs_of(backwards), pairs);
    seen += pairs.size();
  }
  EXPECT_GT(seen, 500u);
}

/// A thin blade that is on one side of a limb at the start, and on the other at the end.
TEST(CollideMoving, FindsWhatNoEndOfTheStepShows) {
  Shape blade;
  blade.rest_positions = {{-0.01f, 0.5f, -1}, {0.01f, 0.5f, -1}, {0, 0.5f, 1}};
  blade.triangles = {{0, 1, 2}};
  blade.influences_per_vertex = 1;
  blade.joints = {0, 0, 0};
  blade.weights = {1, 1, 1};
  Body sword(blade), arm(make_limb(24, 10, 3));
  const std::vector<Matrix4> left = {rotation_about({0, 0, 1}, 0, {}, {-1, 0, 0})};
  const std::vector<Matrix4> right = {rotation_about({0, 0, 1}, 0, {}, {1, 0, 0})};
  sword.move(left, right);
  Scratch scratch;
  EXPECT_FALSE(intersects(sword.from, arm.from, scratch).answer);
  EXPECT_FALSE(intersects(sword.to, arm.to, scratch).answer);
  const auto found = contacts_of(sword, arm);
  EXPECT_GT(found.size(), 5u);
  for (const MovingContact& c : found) EXPECT_TRUE(c.time > 0.3f && c.time < 0.7f);
}

TEST(CollideMoving, RefusesAPoseInBothSteps) {
  Limbs limbs;
  Scratch scratch;
  std::vector<MovingContact> contacts;
  EXPECT_DEATH(collide(limbs.a.step(), {limbs.a.to, limbs.a.to}, scratch, contacts),
               "Motion: `a` and `b` have a pose in common");
  EXPECT_DEATH(collide({limbs.a.from, limbs.b.from}, limbs.b.step(), scratch, contacts),
               "Motion: the poses of a motion are of different models");
}

// The first contact of two moving characters, against all moving contacts.

detail::MeetingPair meeting_pair(const Body& a, const Body& b, const MovingContact& c) {
  const auto s = a.triangles()[c.contact.triangle_a], r = b.triangles()[c.contact.triangle_b];
  return {s, r, *detail::first_meeting(s, r)};
}

/// The first of all contacts that do not touch at the start, by exact times.
std::optional<MovingContact> first_after_start(const Body& a, const Body& b,
                                               const std::vector<MovingContact>& contacts) {
  std::optional<MovingContact> first;
  for (const MovingContact& c : contacts) {
    if (c.at_start || (first && c.time > first->time)) continue;
    if (!first || c.time < first->time ||
        detail::first_time_of(meeting_pair(a, b, c).a, meeting_pair(a, b, c).b)
                .compare(detail::first_time_of(meeting_pair(a, b, *first).a,
                                               meeting_pair(a, b, *first).b)) < 0)
      first = c;
  }
  return first;
}

std::optional<MovingContact> first_contact_of(Body& a, Body& b, bool leave_out_start = false) {
  Scratch scratch;
  std::optional<MovingContact> first;
  first_contact(a.step(), b.step(), scratch, first, {.leave_out_start = leave_out_start});
  return first;
}

TEST(FirstContact, IsTheFirstOfAllContacts) {
  Random random(1821);
  Limbs limbs;
  Scratch scratch;
  int at_start = 0, later = 0, apart = 0, ties = 0;
  for (int round = 0; round < 60; ++round) {
    limbs.move(random, round % 2 ? 0.12 : 0.6);
    std::vector<MovingContact> all;
    collide(limbs.a.step(), limbs.b.step(), scratch, all);
    const auto after = first_after_start(limbs.a, limbs.b, all);
    const auto start =
        std::find_if(all.begin(), all.end(), [](const MovingContact& c) { return c.at_start; });
    EXPECT_EQ(first_contact_of(limbs.a, limbs.b, true), after) << "round " << round;
    EXPECT_EQ(first_contact_of(limbs.a, limbs.b), start == all.end() ? after : *start);
    at_start += start != all.end();
    later += start == all.end() && after;
    apart += all.empty();
    ties += std::count_if(all.begin(), all.end(), [&](const MovingContact& c) {
              return after && !c.at_start && c.time == after->time;
            }) > 1;
  }
  EXPECT_GT(at_start, 10);
  EXPECT_GT(later, 7);
  EXPECT_GT(apart, 3);
  EXPECT_GT(ties, 10);
}

TEST(FirstContact, VisitsLessThanAllContacts) {
  Random random(1824);
  Limbs limbs;
  Scratch scratch;
  std::uint64_t all = 0, first = 0;
  for (int round = 0; round < 30; ++round) {
    limbs.move(random, 0.6);
    std::vector<MovingContact> contacts;
    std::optional<MovingContact> contact;
    all += collide(limbs.a.step(), limbs.b.step(), scratch, contacts).triangle_pairs;
    first += first_contact(limbs.a.step(), limbs.b.step(), scratch, contact).triangle_pairs;
  }
  EXPECT_LT(3 * first, all);
}

// Bodies whose boxes only touch, or overlap at one instant only.

std::vector<Matrix4> moved_by(const Vec3& shift) {
  return {rotation_about({0, 0, 1}, 0, {}, shift)};
}

/// Corner 0 of a is its rightmost and highest, and that of b its leftmost and lowest. b comes from
/// the right and leaves upwards, so that the boxes overlap at time p / q only, when these two
/// corners are at one position. The quotients of gaps that give this time round differently on both
/// axes.
TEST(TouchingSteps, FindCornersThatPassAtOneInstant) {
  Random random(1861);
  Body a(make_rigid({{0, 0, 0}, {-0x1p26f, -0x1p25f, 1}, {-0x1p25f, -0x1p26f, -1}}, {{0, 1, 2}}));
  Body b(make_rigid({{0, 0, 0}, {0x1p26f, 0x1p25f, 1}, {0x1p25f, 0x1p26f, -1}}, {{0, 1, 2}}));
  a.move(moved_by({}), moved_by({}));
  Scratch scratch;
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t p = 1 + random.index(9), q = p + 1 + random.index(9);
    const std::uint32_t most = (1u << 24) / std::max(p, q - p);
    const std::uint32_t m = 1 + random.index(most), n = 1 + random.index(most);
    const auto place = [](std::uint32_t x, std::uint32_t y) {
      return Vec3{static_cast<float>(x), -static_cast<float>(y), 0};
    };
    const Vec3 from = place(p * m, p * n), to = place((q - p) * m, (q - p) * n);
    b.move(moved_by(from), moved_by({-to.x, -to.y, 0}));
    const auto contacts = contacts_of(a, b);
    ASSERT_EQ(contacts.size(), 1u) << "round " << round;
    const MovingContact& contact = contacts.front();
    EXPECT_TRUE(q * double{contact.time} <= p && p < q * double{std::nextafter(contact.time, 2.f)});
    EXPECT_TRUE(contact.a.kind == FeatureKind::corner && contact.b.kind == FeatureKind::corner);
    EXPECT_TRUE(intersects(a.step(), b.step(), scratch).answer);
    std::optional<MovingContact> first;
    first_contact(a.step(), b.step(), scratch, first);
    EXPECT_EQ(first, contact);
  }
}

/// A square of 14 x 14 units in the plane z = 0, with two triangles per unit.
Shape make_sheet() {
  constexpr std::uint32_t kUnits = 14, kRow = kUnits + 1;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (std::uint32_t y = 0; y < kRow; ++y)
    for (std::uint32_t x = 0; x < kRow; ++x) {
      positions.push_back({static_cast<float>(x), static_cast<float>(y), 0});
      const std::uint32_t i = y * kRow + x;
      if (x == kUnits || y == kUnits) continue;
      triangles.push_back({i, i + 1, i + kRow + 1});
      triangles.push_back({i, i + kRow + 1, i + kRow});
    }
  return make_rigid(std::move(positions), std::move(triangles));
}

/// Their borders or corners touch at all times, or they touch at one end of the step.
TEST(TouchingSteps, FindSheetsThatOnlyTouch) {
  Body a(make_sheet()), b(make_sheet());
  a.move(moved_by({}), moved_by({}));
  constexpr std::array<std::pair<Vec3, Vec3>, 6> kSteps = {{{{14, -2, 0}, {14, 3, 0}},
                                                            {{14, 14, 0}, {14, 14, 0}},
                                                            {{-3, -14, 0}, {2, -14, 0}},
                                                            {{-14, 13, 0}, {-14, 15, 0}},
                                                            {{13, 13, 1}, {13, 13, 0}},
                                                            {{-13, 12, 0}, {-13, 12, -2}}}};
  for (const auto& [from, to] : kSteps) {
    b.move(moved_by(from), moved_by(to));
    const auto expected = brute_force(a, b);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(contacts_of(a, b), expected);
  }
}

// Moving contacts of generated characters, whose bits are the same everywhere: contacts, times and
// features. A hash here changes only if the characters or the definitions change.

constexpr int kSteps = 6;

/// A creature in steps of its first clip, at a place.
struct Actor {
  Actor(const scenes::CreatureOptions& options, float x)
      : from(*scenes::make_creature(options)), to(from.pose.model()), place(x) {}

  pelt::Motion step(int number) {
    move(from.pose, number);
    move(to, number + 1);
    return {from.pose, to};
  }

  AnimatedCharacter from;
  Pose to;
  float place;

 private:
  void move(Pose& pose, int frame) {
    std::vector<Matrix4> palette =
        from.palette(from.first_clip(), 0.1f * static_cast<float>(frame));
    for (Matrix4& m : palette) m.m[12] += place;
    ASSERT_TRUE(pose.set_palette(palette));
  }
};

class HashOfContacts {
 public:
  void add(const std::vector<MovingContact>& contacts) {
    for (const auto& [pair, time, at_start, a, b] : contacts) {
      for (const std::uint32_t value : {pair.triangle_a, pair.triangle_b}) hash_.add_u32(value);
      hash_.add_u32(detail::bits_as<std::uint32_t>(time));
      hash_.add_u32(at_start);
      for (const Feature& f : {a, b})
        hash_.add_u32(static_cast<std::uint32_t>(f.kind) << 8 | f.number);
    }
    contacts_ += contacts.size();
  }

  std::uint64_t value() const { return hash_.value(); }
  std::size_t contacts() const { return contacts_; }

 private:
  detail::Fnv1a64 hash_;
  std::size_t contacts_ = 0;
};

TEST(MovingGolden, OfTwoCreaturesIsTheSameOnEveryTarget) {
  Actor man(scenes::kMan, 0), dwarf(scenes::kDwarf, 0.35f);
  on_each_instruction_set([&](InstructionSet) {
    Scratch scratch;
    HashOfContacts hash;
    for (int number = 0; number < kSteps; ++number) {
      std::vector<MovingContact> contacts;
      collide(man.step(number), dwarf.step(number), scratch, contacts);
      hash.add(contacts);
    }
    EXPECT_EQ(hash.contacts(), 15775u);
    EXPECT_EQ(hash.value(), 0xeeb548687d68d0b4);
  });
}

TEST(MovingGolden, OfACreatureWithItselfIsTheSameOnEveryTarget) {
  Actor man(scenes::kMan, 0);
  const SelfFilter filter = *build_self_filter(man.to.model());
  on_each_instruction_set([&](InstructionSet) {
    Scratch scratch;
    HashOfContacts hash;
    for (int number = 0; number < kSteps; ++number) {
      std::vector<MovingContact> contacts;
      self_collide(man.step(number), filter, scratch, contacts);
      hash.add(contacts);
    }
    EXPECT_EQ(hash.contacts(), 28u);
    EXPECT_EQ(hash.value(), 0xf4a4c1d875784c31);
  });
}

}  // namespace
}  // namespace pelt::test
