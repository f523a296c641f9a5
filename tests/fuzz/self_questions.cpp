#include "fuzz/goal.hpp"
#include "fuzz/questions.hpp"
#include "self/exact_neighbours.hpp"
#include "self/self_brute_force.hpp"
#include "support/require.hpp"

#include <pelt/self.hpp>

#include <algorithm>

namespace pelt::test {
namespace {

Goal self_contacts("self_collide: contacts"), self_apart("self_collide: no contact"),
    self_neighbours("self_collide: contacts of neighbours"),
    self_of_nodes("self_collide: contacts in a tree of several nodes"),
    self_left_out("self_collide: contacts left out"), self_limited("self_collide: max_contacts");

SurfaceTriangles surface_triangles(const FuzzedBody& body) {
  const std::vector<std::uint32_t> surface = surface_vertices(body.shape);
  SurfaceTriangles triangles;
  for (std::uint32_t t = 0; t < body.triangle_count(); ++t) {
    const auto [a, b, c] = body.shape.triangles[t];
    triangles.push_back({body.corners(t), {surface[a], surface[b], surface[c]}});
  }
  return triangles;
}

bool are_neighbours(const detail::SurfaceTriangle& s, const detail::SurfaceTriangle& t) {
  return std::find_first_of(s.vertices.begin(), s.vertices.end(), t.vertices.begin(),
                            t.vertices.end()) != s.vertices.end();
}

/// `surface_triangles_intersect` against rational numbers, on the pairs in question.
void check_predicate(const SurfaceTriangles& triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      require(surface_triangles_intersect(triangles[i], triangles[j]) ==
                  ExactNeighbours(triangles[i], triangles[j]).intersect_by_table(),
              "surface_triangles_intersect is not exact");
}

/// Options that leave out some pairs, with what they refer to.
struct FuzzedFilter {
  explicit FuzzedFilter(Question& q) : rings(q.bytes.index(4)) {
    const std::uint32_t count = q.a.triangle_count();
    if (q.bytes.index(2) == 1)
      for (std::uint32_t t = 0; t < count; ++t) takes_part.push_back(q.bytes.next() % 4 > 0);
    for (std::uint32_t i = q.bytes.index(4); i > 0; --i)
      at_rest.push_back({q.bytes.index(count), q.bytes.index(count)});
  }

  SelfFilter of(const SkinnedModel& model) const {
    auto filter =
        build_self_filter(model, {.rings = rings, .takes_part = takes_part, .at_rest = at_rest});
    require(static_cast<bool>(filter), "build_self_filter refuses valid options");
    return *std::move(filter);
  }

  std::uint32_t rings;
  std::vector<std::uint8_t> takes_part;
  std::vector<Contact> at_rest;
};

void check_filtered(Question& q, const std::vector<Contact>& all) {
  const SelfFilter filter = FuzzedFilter(q).of(q.a.pose.model());
  std::vector<Contact> expected, found, some;
  for (const Contact& c : all)
    if (filter.left_out_by(c.triangle_a, c.triangle_b) == LeftOutBy::none) expected.push_back(c);
  const SelfStats work = self_collide(q.a.pose, filter, q.scratch, found);
  require(found == expected, "self_collide with a filter");
  require(work.left_out.total() == all.size() - expected.size(), "left_out");
  require(static_cast<bool>(self_intersects(q.a.pose, filter, q.scratch)) == !expected.empty(),
          "self_intersects with a filter");
  const std::uint32_t limit = q.bytes.index(8);
  const SelfStats limited =
      self_collide(q.a.pose, filter, q.scratch, some, {.max_contacts = limit});
  require(some.size() == std::min<std::size_t>(limit, expected.size()) &&
              std::includes(expected.begin(), expected.end(), some.begin(), some.end()),
          "max_contacts of self_collide");
  require(limited.cut_short || some.size() == expected.size(), "cut_short of self_collide");
  self_left_out.reach(work.left_out.total() > 0);
  self_limited.reach(some.size() < expected.size());
}

}  // namespace

void ask_self_contacts(Question& q) {
  const SurfaceTriangles triangles = surface_triangles(q.a);
  constexpr std::size_t kFew = 8;
  if (triangles.size() <= kFew) check_predicate(triangles);
  const std::vector<Contact> expected = brute_force_self(triangles);
  const SelfFilter all = *build_self_filter(q.a.pose.model());
  require(self_contacts_of(q.a.pose, all, q.scratch) == expected, "self_collide");
  check_filtered(q, expected);
  (expected.empty() ? self_apart : self_contacts).reach();
  self_of_nodes.reach(!expected.empty() && triangles.size() > 128);
  self_neighbours.reach(std::any_of(expected.begin(), expected.end(), [&](const Contact& c) {
    return are_neighbours(triangles[c.triangle_a], triangles[c.triangle_b]);
  }));
}

}  // namespace pelt::test
