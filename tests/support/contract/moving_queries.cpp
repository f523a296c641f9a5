/// Motions of two bodies, and of one body with itself, a region or a field.

#include "field/fields.hpp"
#include "self/self_brute_force.hpp"
#include "self/self_moving_brute_force.hpp"
#include "solid/region_oracle.hpp"
#include "support/contract/query.hpp"

namespace pelt::contract {
namespace {

using MovingContacts = std::vector<MovingContact>;

test::MovingTriangles moving_triangles_of(const Body& body) {
  return test::moving_triangles(body.shape.triangles, body.from, body.to);
}

/// Counts tests in double and in exact numbers as tests of triangles, too.
QueryStats counted(const MovingStats& work) {
  QueryStats all = work;
  all.triangle_pairs += work.double_pairs + work.exact_pairs;
  return all;
}

MovingContacts moving_contacts_of_all_pairs(const Stage& stage) {
  return test::brute_force_moving(moving_triangles_of(stage.a), moving_triangles_of(stage.b));
}

bool meet(const Stage& stage) { return !moving_contacts_of_all_pairs(stage).empty(); }

void swap_moving_contacts(MovingContacts& contacts) {
  for (MovingContact& c : contacts) std::swap(c.contact.triangle_a, c.contact.triangle_b);
  std::sort(contacts.begin(), contacts.end(),
            [](const MovingContact& x, const MovingContact& y) { return x.contact < y.contact; });
}

/// If several features meet at the first time, which of them are written depends on the order.
void forget_features(MovingContacts& contacts) {
  for (MovingContact& c : contacts) c.a = c.b = {};
}

Motion resting(Body& body) { return {body.to, body.to}; }

MovingContacts contacts_with_one_at_rest(const Stage& stage) {
  const Body& a = stage.a;
  return test::brute_force_moving(test::moving_triangles(a.shape.triangles, a.to, a.to),
                                  moving_triangles_of(stage.b));
}

using First = std::optional<MovingContact>;

/// MovingContacts at equal times in float may differ in their exact times.
void expect_first(const MovingContacts& all, const First& found) {
  ASSERT_EQ(found.has_value(), !all.empty());
  if (!found) return;
  const auto order = [](const MovingContact& c) { return std::pair(!c.at_start, c.time); };
  for (const MovingContact& contact : all) EXPECT_LE(order(*found), order(contact));
  EXPECT_NE(std::find(all.begin(), all.end(), *found), all.end());
}

void make_first_contact_search(Stage& stage) {
  stage.first_contact_search.emplace(stage.a.motion(), stage.b.motion());
}

QueryStats run_first_contact_search(Stage& stage, First& found) {
  FirstContactSearch& search = *stage.first_contact_search;
  search.restart();
  QueryStats work;
  while (!search.is_complete()) work += search.advance(1000);
  found = search.earliest();
  work.cut_short = false;  // by the budgets
  return work;
}

MovingContacts self_moving_contacts_of_all_pairs(const Stage& stage) {
  const Shape& shape = stage.a.shape;
  const auto corners = test::surface_corners(shape.triangles, test::surface_vertices(shape));
  return left_by(stage.filter,
                 test::brute_force_self_moving(moving_triangles_of(stage.a), corners, true));
}

MovingContacts moving_contacts_with_field(const Stage& stage) {
  MovingContacts contacts;
  const test::MovingTriangles triangles = moving_triangles_of(stage.a);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t k = 0; k < stage.field.triangle_count(); ++k) {
      const auto corners = stage.field.triangle(k);
      const detail::MovingTriangle still = {corners, corners};
      if (test::is_hole(corners) || test::are_far(triangles[i], still)) continue;
      if (const auto first = test::first_meeting_of(triangles[i], still))
        contacts.push_back(test::contact_of(i, k, *first));
    }
  return contacts;
}

std::vector<RegionEntry> entries_of_all_triangles(const Stage& stage) {
  return test::brute_force_moving(stage.region, moving_triangles_of(stage.a));
}

}  // namespace

void add_moving_queries(Queries& queries) {
  const auto is_found = [](const First& first) { return first.has_value(); };
  const auto expect_right = [](const Stage& s, const First& first) {
    expect_first(moving_contacts_of_all_pairs(s), first);
  };
  add(queries, ListRow<MovingContact>{
                   .name = "CollideMoving",
                   .ask =
                       [](Stage& s, MovingContacts& contacts, std::uint32_t limit) {
                         return counted(collide(s.a.motion(), s.b.motion(), s.scratch, contacts,
                                                {.max_contacts = limit}));
                       },
                   .brute_force = moving_contacts_of_all_pairs,
                   .traits = {.is_costly = true, .is_limited = true, .of_two_bodies = true},
                   .swap = swap_moving_contacts,
                   .forget_order = forget_features});
  add(queries,
      ListRow<MovingContact>{.name = "CollideMovingWithOneAtRest",
                             .ask =
                                 [](Stage& s, MovingContacts& contacts, std::uint32_t limit) {
                                   return counted(collide(resting(s.a), s.b.motion(), s.scratch,
                                                          contacts, {.max_contacts = limit}));
                                 },
                             .brute_force = contacts_with_one_at_rest,
                             .traits = {.is_costly = true, .is_limited = true}});
  add(queries,
      YesNoRow{.name = "TouchWhileMoving",
               .ask = [](Stage& s) { return intersects(s.a.motion(), s.b.motion(), s.scratch); },
               .brute_force = meet,
               .traits = {.is_costly = true, .of_two_bodies = true}});
  add(queries, ValueRow<First>{.name = "FirstContact",
                               .ask =
                                   [](Stage& s, First& first) {
                                     return counted(first_contact(s.a.motion(), s.b.motion(),
                                                                  s.scratch, first));
                                   },
                               .expect_right = expect_right,
                               .is_hit = is_found,
                               .traits = {.is_costly = true}});
  add(queries, ValueRow<First>{.name = "FirstContactSearch",
                               .ask = run_first_contact_search,
                               .expect_right = expect_right,
                               .is_hit = is_found,
                               .traits = {.is_costly = true, .reserves_when_asked = true},
                               .preparation = {.make = make_first_contact_search}});
  add(queries,
      ListRow<MovingContact>{.name = "SelfCollideMoving",
                             .ask =
                                 [](Stage& s, MovingContacts& contacts, std::uint32_t limit) {
                                   return counted(self_collide(s.a.motion(), s.filter, s.scratch,
                                                               contacts, {.max_contacts = limit}));
                                 },
                             .brute_force = self_moving_contacts_of_all_pairs,
                             .traits = {.is_costly = true, .is_limited = true}});
  add(queries,
      YesNoRow{.name = "SelfTouchesWhileMoving",
               .ask = [](Stage& s) { return self_intersects(s.a.motion(), s.filter, s.scratch); },
               .brute_force =
                   [](const Stage& s) { return !self_moving_contacts_of_all_pairs(s).empty(); },
               .traits = {.is_costly = true}});
  add(queries,
      ListRow<MovingContact>{.name = "CollideMovingWithField",
                             .ask =
                                 [](Stage& s, MovingContacts& contacts, std::uint32_t limit) {
                                   return counted(collide(s.a.motion(), s.field, s.scratch,
                                                          contacts, {.max_contacts = limit}));
                                 },
                             .brute_force = moving_contacts_with_field,
                             .traits = {.is_costly = true, .is_limited = true}});
  add(queries,
      YesNoRow{
          .name = "TouchFieldWhileMoving",
          .ask = [](Stage& s) { return intersects(s.a.motion(), s.field, s.scratch); },
          .brute_force = [](const Stage& s) { return !moving_contacts_with_field(s).empty(); }});
  add(queries, ListRow<RegionEntry>{
                   .name = "CollideMovingWithRegion",
                   .ask =
                       [](Stage& s, std::vector<RegionEntry>& entries, std::uint32_t limit) {
                         return counted(collide(s.a.motion(), s.region, s.scratch, entries,
                                                {.max_contacts = limit}));
                       },
                   .brute_force = entries_of_all_triangles,
                   .traits = {.is_costly = true, .is_limited = true}});
  add(queries,
      YesNoRow{.name = "TouchRegionWhileMoving",
               .ask = [](Stage& s) { return intersects(s.a.motion(), s.region, s.scratch); },
               .brute_force = [](const Stage& s) { return !entries_of_all_triangles(s).empty(); }});
}

}  // namespace pelt::contract
