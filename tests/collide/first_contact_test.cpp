/// The first contact of two moving characters, against all moving contacts.

#include "motion/meeting_order.hpp"
#include "moving_bodies.hpp"

namespace pelt::test {
namespace {

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

}  // namespace
}  // namespace pelt::test
