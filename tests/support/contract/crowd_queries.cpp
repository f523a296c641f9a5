/// Crowds of three instances: both bodies, and the first one at rest where it begins.

#include "collide/moving_brute_force.hpp"
#include "self/self_brute_force.hpp"
#include "support/contract/query.hpp"

namespace pelt::contract {
namespace {

/// An instance of the crowd: the shape, and its poses.
struct Instance {
  const Shape& shape;
  const Pose &from, &to;
  const SelfFilter& filter;
};

std::array<Instance, 3> instances_of(const Stage& stage) {
  const auto& [a, b] = std::tie(stage.a, stage.b);
  return {Instance{a.shape, a.from, a.to, stage.filter},
          {b.shape, b.from, b.to, stage.filter_b},
          {a.shape, a.from, a.from, stage.filter}};
}

/// Moves the first two instances back and forth.
void make_crowd(Stage& stage) {
  Crowd& crowd = stage.crowd.emplace();
  const std::pair<const PoseInput&, const PoseInput&> steps[] = {
      {stage.a.from_input, stage.a.to_input},
      {stage.b.from_input, stage.b.to_input},
      {stage.a.from_input, stage.a.from_input}};
  for (const Body* body : {&stage.a, &stage.b, &stage.a}) crowd.add(body->to.model());
  std::vector<CrowdContact> ignored;
  for (std::uint32_t i = 0; i < 3; ++i) apply(steps[i].second, crowd, i);
  crowd.begin_step();
  for (std::uint32_t i = 0; i < 3; ++i) apply(steps[i].first, crowd, i);
  crowd.collide(ignored, {.threads = 1});
  crowd.begin_step();
  for (std::uint32_t i = 0; i < 3; ++i) apply(steps[i].second, crowd, i);
}

CrowdOptions with_threads(const Stage& stage) {
  CrowdOptions options;
  options.threads = stage.threads;
  return options;
}

/// Also tests each instance against itself.
CrowdOptions with_self_tests(const Stage& stage) {
  CrowdOptions options = with_threads(stage);
  options.self_filter = [&](std::uint32_t i) { return i == 1 ? &stage.filter_b : &stage.filter; };
  return options;
}

std::vector<Contact> contacts_of_instances(const Instance& a, const Instance& b) {
  if (&a.to == &b.to) return left_by(a.filter, test::brute_force_self(a.shape, a.to));
  return test::brute_force(a.shape.triangles, a.to, b.shape.triangles, b.to);
}

std::vector<CrowdContact> all_contacts(const Stage& stage) {
  std::vector<CrowdContact> all;
  const auto instances = instances_of(stage);
  for (std::uint32_t i = 0; i < 3; ++i)
    for (std::uint32_t j = i; j < 3; ++j)
      for (const Contact& c : contacts_of_instances(instances[i], instances[j]))
        all.push_back({i, j, c.triangle_a, c.triangle_b});
  return all;
}

test::MovingTriangles moving_triangles(const Instance& instance) {
  return test::moving_triangles(instance.shape.triangles, instance.from, instance.to);
}

std::vector<CrowdMovingContact> all_moving_contacts(const Stage& stage) {
  std::vector<CrowdMovingContact> all;
  const auto instances = instances_of(stage);
  for (std::uint32_t i = 0; i < 3; ++i)
    for (std::uint32_t j = i + 1; j < 3; ++j)
      for (const MovingContact& contact :
           test::brute_force_moving(moving_triangles(instances[i]), moving_triangles(instances[j])))
        all.push_back({i, j, contact});
  return all;
}

std::vector<CrowdPair> pairs_of(const std::vector<CrowdContact>& contacts) {
  std::vector<CrowdPair> pairs;
  for (const CrowdContact& c : contacts) pairs.push_back({c.instance_a, c.instance_b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

QueryStats run_crowd_search(Stage& stage, std::vector<CrowdContact>& contacts, std::uint32_t) {
  std::vector<UndecidedPair> undecided;
  const CrowdStats work = stage.crowd->search(
      contacts, undecided, {.slice = 700, .order = SearchOrder::contacts}, with_threads(stage));
  EXPECT_TRUE(undecided.empty());
  return work;
}

constexpr Traits kTraits = {
    .has_threads = true, .reserves_when_asked = true, .varies_in_work = true, .always_hits = true};

constexpr Traits kSearchTraits = {
    .has_threads = true, .allocates = true, .varies_in_work = true, .always_hits = true};

constexpr Traits kMovingTraits = {.is_costly = true,
                                  .has_threads = true,
                                  .reserves_when_asked = true,
                                  .varies_in_work = true,
                                  .always_hits = true};

}  // namespace

void add_crowd_queries(Queries& queries) {
  add(queries, ListRow<CrowdContact>{.name = "CrowdCollide",
                                     .ask = [](Stage& s, std::vector<CrowdContact>& found,
                                               std::uint32_t) -> QueryStats {
                                       return s.crowd->collide(found, with_self_tests(s));
                                     },
                                     .brute_force = all_contacts,
                                     .traits = kTraits,
                                     .preparation = {.make = make_crowd}});
  add(queries, ListRow<CrowdPair>{
                   .name = "CrowdIntersectingPairs",
                   .ask = [](Stage& s, std::vector<CrowdPair>& found, std::uint32_t) -> QueryStats {
                     return s.crowd->intersecting_pairs(found, with_self_tests(s));
                   },
                   .brute_force = [](const Stage& s) { return pairs_of(all_contacts(s)); },
                   .traits = kTraits,
                   .preparation = {.make = make_crowd}});
  add(queries,
      ListRow<CrowdMovingContact>{
          .name = "CrowdCollideMoving",
          .ask = [](Stage& s, std::vector<CrowdMovingContact>& found, std::uint32_t) -> QueryStats {
            return s.crowd->collide(found, with_threads(s));
          },
          .brute_force = all_moving_contacts,
          .traits = kMovingTraits,
          .preparation = {.make = make_crowd}});
  add(queries, ListRow<CrowdContact>{.name = "CrowdSearch",
                                     .ask = run_crowd_search,
                                     .brute_force =
                                         [](const Stage& s) {
                                           std::vector<CrowdContact> all = all_contacts(s);
                                           std::erase_if(all, [](const CrowdContact& c) {
                                             return c.instance_a == c.instance_b;
                                           });
                                           return all;
                                         },
                                     .traits = kSearchTraits,
                                     .preparation = {.make = make_crowd}});
}

}  // namespace pelt::contract
