/// Contacts of two bodies, and of one body with itself, that do not move.

#include "collide/collide_trees.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "self/self_brute_force.hpp"
#include "support/contract/query.hpp"

namespace pelt::contract {
namespace {

std::vector<Contact> contacts_of_all_pairs(const Stage& stage) {
  return test::brute_force(stage.a.shape.triangles, stage.a.to, stage.b.shape.triangles,
                           stage.b.to);
}

bool touch(const Stage& stage) { return !contacts_of_all_pairs(stage).empty(); }

void swap_contacts(std::vector<Contact>& contacts) {
  for (Contact& c : contacts) std::swap(c.triangle_a, c.triangle_b);
  std::sort(contacts.begin(), contacts.end());
}

QueryStats lowest(Stage& stage, std::optional<Contact>& found) {
  return lowest_contact(stage.a.to.detail().posed_tree(), stage.b.to.detail().posed_tree(),
                        stage.scratch.detail(), found);
}

void make_collision_search(Stage& stage) {
  stage.search.emplace(stage.a.to, stage.b.to, SearchOrder::contacts);
}

QueryStats run_collision_search(Stage& stage, std::vector<Contact>& contacts, std::uint32_t) {
  stage.search->restart();
  QueryStats work;
  while (!stage.search->is_complete()) work += stage.search->advance(1000, stage.scratch);
  const std::span<const Contact> found = stage.search->contacts();
  contacts.insert(contacts.end(), found.begin(), found.end());
  EXPECT_EQ(stage.search->verdict(), found.empty() ? Verdict::apart : Verdict::touching);
  EXPECT_EQ(stage.search->undecided_pairs(), 0u);
  work.cut_short = false;  // by the budgets
  return work;
}

QueryStats describe(Stage& stage, ContactGeometry& geometry) {
  std::vector<Contact>& contacts = stage.described;
  contacts.clear();
  QueryStats work = collide(stage.a.to, stage.b.to, stage.scratch, contacts);
  work += describe_contacts(stage.a.to, stage.b.to, contacts, stage.scratch, geometry);
  return work;
}

void expect_complete(const std::vector<Contact>& contacts, const ContactGeometry& geometry) {
  std::vector<Contact> traced;
  for (const ContactTrace& trace : geometry.traces) traced.push_back(trace.contact);
  EXPECT_EQ(traced, contacts);
  std::vector<std::uint32_t> members = geometry.members;
  std::sort(members.begin(), members.end());
  for (std::uint32_t i = 0; i < members.size(); ++i) ASSERT_EQ(members[i], i);
  EXPECT_EQ(members.size(), contacts.size());
}

bool has_traces(const ContactGeometry& geometry) { return !geometry.traces.empty(); }

std::vector<Contact> self_contacts_of_all_pairs(const Stage& stage) {
  return left_by(stage.filter, test::brute_force_self(stage.a.shape, stage.a.to));
}

bool touches_itself(const Stage& stage) { return !self_contacts_of_all_pairs(stage).empty(); }

QueryStats describe_self(Stage& stage, ContactGeometry& geometry) {
  std::vector<Contact>& contacts = stage.described;
  contacts.clear();
  QueryStats work = self_collide(stage.a.to, stage.filter, stage.scratch, contacts);
  work += describe_contacts(stage.a.to, contacts, stage.scratch, geometry);
  return work;
}

void make_tracker(Stage& stage) { stage.tracker.emplace(stage.filter); }

/// Tracks the body from another pose to the pose of the answer.
QueryStats track(Stage& stage, std::vector<Contact>& contacts, std::uint32_t limit) {
  SelfTracker& tracker = *stage.tracker;
  const std::size_t before = contacts.size();
  QueryStats work = self_collide(stage.a.from, tracker, stage.scratch, contacts, {limit});
  for (int frame = 0; frame < 2; ++frame) {
    contacts.resize(before);
    work = self_collide(stage.a.to, tracker, stage.scratch, contacts, {limit});
  }
  return work;
}

}  // namespace

void add_contact_queries(Queries& queries) {
  add(queries,
      ListRow<Contact>{.name = "Collide",
                       .ask =
                           [](Stage& s, std::vector<Contact>& contacts, std::uint32_t limit) {
                             return collide(s.a.to, s.b.to, s.scratch, contacts, {limit});
                           },
                       .brute_force = contacts_of_all_pairs,
                       .traits = {.is_limited = true, .of_two_bodies = true},
                       .swap = swap_contacts});
  add(queries, YesNoRow{.name = "Intersects",
                        .ask = [](Stage& s) { return intersects(s.a.to, s.b.to, s.scratch); },
                        .brute_force = touch,
                        .traits = {.of_two_bodies = true}});
  add(queries,
      ValueRow<std::optional<Contact>>{
          .name = "LowestContact",
          .ask = lowest,
          .expect_right =
              [](const Stage& s, const std::optional<Contact>& found) {
                const std::vector<Contact> all = contacts_of_all_pairs(s);
                EXPECT_EQ(found, all.empty() ? std::nullopt : std::optional(all[0]));
              },
          .is_hit = [](const std::optional<Contact>& found) { return found.has_value(); }});
  add(queries, ListRow<Contact>{.name = "CollisionSearch",
                                .ask = run_collision_search,
                                .brute_force = contacts_of_all_pairs,
                                .traits = {.of_two_bodies = true, .reserves_when_asked = true},
                                .swap = swap_contacts,
                                .preparation = {.make = make_collision_search}});
  add(queries, ValueRow<ContactGeometry>{.name = "DescribeContacts",
                                         .ask = describe,
                                         .expect_right =
                                             [](const Stage& s, const ContactGeometry& g) {
                                               expect_complete(contacts_of_all_pairs(s), g);
                                             },
                                         .is_hit = has_traces,
                                         .traits = {.reserves_when_asked = true}});
}

void add_self_queries(Queries& queries) {
  add(queries,
      ListRow<Contact>{.name = "SelfCollide",
                       .ask =
                           [](Stage& s, std::vector<Contact>& contacts, std::uint32_t limit) {
                             return self_collide(s.a.to, s.filter, s.scratch, contacts, {limit});
                           },
                       .brute_force = self_contacts_of_all_pairs,
                       .traits = {.is_limited = true}});
  add(queries,
      YesNoRow{.name = "SelfIntersects",
               .ask = [](Stage& s) { return self_intersects(s.a.to, s.filter, s.scratch); },
               .brute_force = touches_itself});
  add(queries,
      ListRow<Contact>{
          .name = "SelfTracker",
          .ask = track,
          .brute_force = self_contacts_of_all_pairs,
          .traits = {.is_limited = true, .reserves_when_asked = true, .varies_in_work = true},
          .preparation = {.make = make_tracker}});
  add(queries, ValueRow<ContactGeometry>{.name = "DescribeSelfContacts",
                                         .ask = describe_self,
                                         .expect_right =
                                             [](const Stage& s, const ContactGeometry& g) {
                                               expect_complete(self_contacts_of_all_pairs(s), g);
                                             },
                                         .is_hit = has_traces,
                                         .traits = {.reserves_when_asked = true}});
}

}  // namespace pelt::contract
