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

/// A query of motions that appends to a list, with any options.
template <typename Item>
using AskWithOptions = std::function<MovingStats(Stage&, std::vector<Item>&, const MovingOptions&)>;

std::uint32_t triangles_of(const RegionEntry& entry) { return entry.triangle; }
Contact triangles_of(const MovingContact& contact) { return contact.contact; }

/// Adds the query, and the same with each option.
template <typename Item>
void add_with_options(Queries& queries, const AskWithOptions<Item>& ask, ListRow<Item> row) {
  row.traits.is_costly = row.traits.is_limited = true;
  for (const bool leaves_out_start : {false, true})
    for (const bool has_times : {true, false}) {
      ListRow<Item> with = row;
      with.ask = [=](Stage& s, std::vector<Item>& items, std::uint32_t limit) {
        return counted(ask(s, items, {leaves_out_start, has_times, limit}));
      };
      if (leaves_out_start || !has_times) with.traits.of_two_bodies = false;
      if (leaves_out_start) {
        with.name += "Later";
        with.brute_force = [all = row.brute_force](const Stage& stage) {
          std::vector<Item> items = all(stage);
          std::erase_if(items, [](const Item& item) { return item.at_start; });
          return items;
        };
      }
      if (!has_times) {
        with.name += "WithoutTimes";
        with.is_right = [](const Stage&, const Item& found, const Item& expected) {
          return triangles_of(found) == triangles_of(expected) && found.time == 0 &&
                 !found.at_start;
        };
      }
      add(queries, std::move(with));
    }
}

}  // namespace

void add_moving_queries(Queries& queries) {
  const auto is_found = [](const First& first) { return first.has_value(); };
  const auto expect_right = [](const Stage& s, const First& first) {
    expect_first(moving_contacts_of_all_pairs(s), first);
  };
  add_with_options<MovingContact>(
      queries,
      [](Stage& s, MovingContacts& contacts, const MovingOptions& options) {
        return collide(s.a.motion(), s.b.motion(), s.scratch, contacts, options);
      },
      {.name = "CollideMoving",
       .brute_force = moving_contacts_of_all_pairs,
       .traits = {.of_two_bodies = true},
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
  add_with_options<MovingContact>(
      queries,
      [](Stage& s, MovingContacts& contacts, const MovingOptions& options) {
        return self_collide(s.a.motion(), s.filter, s.scratch, contacts, options);
      },
      {.name = "SelfCollideMoving", .brute_force = self_moving_contacts_of_all_pairs});
  add(queries,
      YesNoRow{.name = "SelfTouchesWhileMoving",
               .ask = [](Stage& s) { return self_intersects(s.a.motion(), s.filter, s.scratch); },
               .brute_force =
                   [](const Stage& s) { return !self_moving_contacts_of_all_pairs(s).empty(); },
               .traits = {.is_costly = true}});
  add_with_options<MovingContact>(
      queries,
      [](Stage& s, MovingContacts& contacts, const MovingOptions& options) {
        return collide(s.a.motion(), s.field, s.scratch, contacts, options);
      },
      {.name = "CollideMovingWithField", .brute_force = moving_contacts_with_field});
  add(queries,
      YesNoRow{
          .name = "TouchFieldWhileMoving",
          .ask = [](Stage& s) { return intersects(s.a.motion(), s.field, s.scratch); },
          .brute_force = [](const Stage& s) { return !moving_contacts_with_field(s).empty(); }});
  add_with_options<RegionEntry>(
      queries,
      [](Stage& s, std::vector<RegionEntry>& entries, const MovingOptions& options) {
        return collide(s.a.motion(), s.region, s.scratch, entries, options);
      },
      {.name = "CollideMovingWithRegion", .brute_force = entries_of_all_triangles});
  add(queries,
      YesNoRow{.name = "TouchRegionWhileMoving",
               .ask = [](Stage& s) { return intersects(s.a.motion(), s.region, s.scratch); },
               .brute_force = [](const Stage& s) { return !entries_of_all_triangles(s).empty(); }});
}

}  // namespace pelt::contract
