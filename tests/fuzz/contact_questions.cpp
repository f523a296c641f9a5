#include "fuzz/goal.hpp"
#include "fuzz/pair_oracle.hpp"
#include "fuzz/questions.hpp"
#include "motion/hulls_meet.hpp"
#include "support/exact_winding.hpp"
#include "support/require.hpp"

#include <pelt/surface.hpp>

#include <algorithm>

namespace pelt::test {
namespace {

Goal contacts_found("collide: contacts"), no_contact("collide: no contact"),
    contacts_of_nodes("collide: contacts in a tree of several nodes"),
    segments_found("describe_contacts: segments"), other_kinds("describe_contacts: other kinds");

BigTriangle big_triangle(const detail::TriangleCorners& t) {
  return {to_big(t[0]), to_big(t[1]), to_big(t[2])};
}

/// `triangles_intersect` against integers, on the pair in question.
void check_predicate(const detail::TriangleCorners& a, const detail::TriangleCorners& b) {
  require(
      detail::triangles_intersect(a, b) == hulls_meet<mpz_class>(big_triangle(a), big_triangle(b)),
      "triangles_intersect is not exact");
}

std::vector<Contact> expected_contacts(const FuzzedBody& a, const FuzzedBody& b) {
  const auto triangles_a = a.all_corners(), triangles_b = b.all_corners();
  if (a.is_small() && b.is_small())
    for (const detail::TriangleCorners& s : triangles_a)
      for (const detail::TriangleCorners& t : triangles_b) check_predicate(s, t);
  return intersecting_pairs(triangles_a, triangles_b);
}

void check_limit(Question& q, const std::vector<Contact>& expected) {
  const std::uint32_t limit = q.bytes.index(8);
  std::vector<Contact> some;
  const QueryStats work = collide(q.a.pose, q.b.pose, q.scratch, some, {.max_contacts = limit});
  require(some.size() == std::min<std::size_t>(limit, expected.size()), "max_contacts");
  require(std::includes(expected.begin(), expected.end(), some.begin(), some.end()),
          "a contact within max_contacts");
  require(work.cut_short || some.size() == expected.size(), "cut_short of collide");
}

std::vector<Contact> contacts_of(Question& q) {
  std::vector<Contact> found;
  collide(q.a.pose, q.b.pose, q.scratch, found);
  return found;
}

using FloatMember = float Vec3::*;
constexpr FloatMember kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// Whether a point is in the box of a triangle, up to the error of the points of traces.
bool is_near_box(const Vec3& p, const detail::TriangleCorners& t, double error) {
  for (const FloatMember axis : kAxes) {
    const auto [low, high] = std::minmax({t[0].*axis, t[1].*axis, t[2].*axis});
    if (double{p.*axis} < double{low} - error || double{p.*axis} > double{high} + error)
      return false;
  }
  return true;
}

double largest_coordinate(const detail::TriangleCorners& t) {
  double largest = 0;
  for (const Vec3& p : t)
    for (const FloatMember axis : kAxes) largest = std::max(largest, std::abs(double{p.*axis}));
  return largest;
}

void check_trace(const Question& q, const ContactTrace& trace) {
  if (trace.kind != ContactKind::segment && trace.kind != ContactKind::point) return;
  const detail::TriangleCorners a = q.a.corners(trace.contact.triangle_a);
  const detail::TriangleCorners b = q.b.corners(trace.contact.triangle_b);
  const double error = 0x1p-23 * std::max(largest_coordinate(a), largest_coordinate(b));
  for (const Vec3& end : {trace.from, trace.to})
    require(is_near_box(end, a, error) && is_near_box(end, b, error), "the end of a trace");
  require(trace.depth >= 0, "the depth of a trace");
}

/// Whether `found` has each of 0 to count - 1 once.
bool is_permutation_of(std::vector<std::uint32_t> found, std::size_t count) {
  std::sort(found.begin(), found.end());
  if (found.size() != count) return false;
  for (std::uint32_t i = 0; i < count; ++i)
    if (found[i] != i) return false;
  return true;
}

/// Every segment is in one curve, once.
void check_curves(const ContactGeometry& geometry) {
  std::vector<std::uint32_t> steps, segments;
  for (const CurveStep& step : geometry.steps) steps.push_back(step.trace);
  for (std::uint32_t i = 0; i < geometry.traces.size(); ++i)
    if (geometry.traces[i].kind == ContactKind::segment) segments.push_back(i);
  std::sort(steps.begin(), steps.end());
  require(steps == segments, "the segments of the curves");
  std::size_t count = 0;
  for (const ContactCurve& curve : geometry.curves) {
    require(curve.first == count && curve.count > 0, "the range of a curve");
    count += curve.count;
  }
  require(count == geometry.steps.size(), "the ranges of the curves");
}

}  // namespace

void ask_contacts(Question& q) {
  const std::vector<Contact> expected = expected_contacts(q.a, q.b);
  require(static_cast<bool>(intersects(q.a.pose, q.b.pose, q.scratch)) == !expected.empty(),
          "intersects");
  require(contacts_of(q) == expected, "collide");
  check_limit(q, expected);
  (expected.empty() ? no_contact : contacts_found).reach();
  contacts_of_nodes.reach(!expected.empty() &&
                          std::max(q.a.triangle_count(), q.b.triangle_count()) > 128);
}

void ask_contact_geometry(Question& q) {
  const std::vector<Contact> found = contacts_of(q);
  ContactGeometry geometry;
  describe_contacts(q.a.pose, q.b.pose, found, q.scratch, geometry);
  require(geometry.traces.size() == found.size(), "describe_contacts leaves contacts out");
  for (std::size_t i = 0; i < found.size(); ++i) {
    require(geometry.traces[i].contact == found[i], "the contact of a trace");
    check_trace(q, geometry.traces[i]);
  }
  check_curves(geometry);
  require(is_permutation_of(geometry.members, found.size()), "the members of regions");
  segments_found.reach(!geometry.curves.empty());
  other_kinds.reach(geometry.steps.size() < found.size());
}

}  // namespace pelt::test
