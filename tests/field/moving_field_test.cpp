/// A moving character against a height field, against the exact test of all pairs of triangles.

#include "collide/moving_bodies.hpp"
#include "fields.hpp"
#include "support/instruction_sets.hpp"

namespace pelt::test {
namespace {

std::vector<MovingContact> brute_force(const Body& body, const HeightField& field) {
  MovingStats work;
  std::vector<MovingContact> contacts;
  const auto triangles = body.triangles();
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t k = 0; k < field.triangle_count(); ++k) {
      const auto corners = field.triangle(k);
      const detail::MovingTriangle still = {corners, corners};
      if (is_hole(corners) || are_far(triangles[i], still)) continue;
      if (const auto first = detail::find_first_meeting(triangles[i], still, work)) {
        MovingContact contact{{i, k}, first->time, first->at_start, {}, {}};
        if (!first->at_start) contact.a = feature(first->a), contact.b = feature(first->b);
        contacts.push_back(contact);
      }
    }
  return contacts;
}

std::vector<MovingContact> contacts_of(Body& body, const HeightField& field,
                                       const MovingOptions& options = {}) {
  Scratch scratch;
  std::vector<MovingContact> contacts;
  collide(body.step(), field, scratch, contacts, options);
  return contacts;
}

/// A bending limb that moves over hills, into them or through them.
struct Hike {
  explicit Hike(Random& random) {
    const float spacing = random.uniformf(0.05, 0.3);
    field =
        make_hills(random, 12, 12, {-6 * spacing, 0.1f, -6 * spacing}, spacing, 0.4, 0.05).build();
    const auto palette = [&] {
      const double angle = random.uniform(-0.4, 0.4);
      return bend_limb(random, 3, angle, random.point(0.35));
    };
    const auto from = palette(), to = palette();
    limb.move(from, to);
  }

  Body limb = Body(make_limb(10, 6, 3));
  HeightField field = make_plain(2, 2, {}, 1).build();
};

TEST(MovingField, EqualsTheExactTestOfAllPairs) {
  Random random(1851);
  std::size_t at_start = 0, later = 0;
  int apart = 0;
  for (int round = 0; round < 12; ++round) {
    Hike hike(random);
    const auto expected = brute_force(hike.limb, hike.field);
    ASSERT_EQ(contacts_of(hike.limb, hike.field), expected) << "round " << round;
    for (const MovingContact& c : expected) ++(c.at_start ? at_start : later);
    apart += expected.empty();
  }
  std::printf("seed 1851: %zu contacts at the start, %zu later, %d steps without\n", at_start,
              later, apart);
  EXPECT_GT(at_start, 50u);
  EXPECT_GT(later, 300u);
}

TEST(MovingField, HasTheOptionsOfTwoMotions) {
  Random random(1852);
  std::size_t all_count = 0;
  int touching = 0, apart = 0;
  for (int round = 0; round < 30; ++round) {
    Hike hike(random);
    const auto all = contacts_of(hike.limb, hike.field);
    std::vector<MovingContact> rest;
    for (const MovingContact& c : all)
      if (!c.at_start) rest.push_back(c);
    EXPECT_EQ(contacts_of(hike.limb, hike.field, {.leave_out_start = true}), rest);
    EXPECT_EQ(contacts_of(hike.limb, hike.field, {.times = false}).size(), all.size());
    const std::size_t some = std::min<std::size_t>(all.size(), 7);
    EXPECT_EQ(contacts_of(hike.limb, hike.field, {.max_contacts = 7}).size(), some);
    Scratch scratch;
    EXPECT_EQ(intersects(hike.limb.step(), hike.field, scratch).answer, !all.empty());
    all_count += all.size();
    ++(all.empty() ? apart : touching);
  }
  EXPECT_GT(all_count, 1000u);
  EXPECT_GT(touching, 10);
  EXPECT_GT(apart, 1);
}

TEST(MovingField, IsTheSameWithEveryInstructionSet) {
  Random random(1853);
  std::size_t found = 0;
  for (int round = 0; round < 8; ++round) {
    Hike hike(random);
    const auto expected = contacts_of(hike.limb, hike.field);
    found += expected.size();
    on_each_instruction_set(
        [&](InstructionSet) { EXPECT_EQ(contacts_of(hike.limb, hike.field), expected); });
  }
  EXPECT_GT(found, 300u);
}

/// A foot that goes through a thin bridge from one frame to the next.
TEST(MovingField, FindsWhatNoEndOfTheStepShows) {
  Body limb(make_limb(10, 6, 3));
  const auto at_height = [](float y) {
    std::vector<Matrix4> palette(3);
    for (Matrix4& m : palette) m.m[13] = y;
    return palette;
  };
  limb.move(at_height(0.5f), at_height(-2));
  const HeightField field = make_plain(6, 6, {-1, 0, -1}, 0.4f).build();
  Scratch scratch;
  EXPECT_FALSE(intersects(limb.from, field, scratch));
  EXPECT_FALSE(intersects(limb.to, field, scratch));
  EXPECT_GT(contacts_of(limb, field).size(), 10u);
}

}  // namespace
}  // namespace pelt::test
