/// Geometry of contacts of a pose with itself.

#include <pelt/self.hpp>
#include <pelt/surface.hpp>

#include "contact/triangle_crossing.hpp"
#include "support/closed_shapes.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace pelt::test {
namespace {

/// A posed model and its filter.
struct Body {
  explicit Body(const Shape& s)
      : shape(s), pose(*build_model(s.view())), filter(*build_self_filter(pose.model())) {}

  void set(const std::vector<Matrix4>& palette) { ASSERT_TRUE(pose.set_palette(palette)); }

  Shape shape;
  Pose pose;
  SelfFilter filter;
};

ContactGeometry geometry_of(Body& body) {
  Scratch scratch;
  std::vector<Contact> contacts;
  self_collide(body.pose, body.filter, scratch, contacts);
  ContactGeometry geometry;
  describe_contacts(body.pose, contacts, scratch, geometry);
  EXPECT_EQ(geometry.traces.size(), contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    EXPECT_EQ(geometry.traces[i].contact, contacts[i]);
  return geometry;
}

using Point = std::tuple<float, float, float>;
using Segment = std::pair<Point, Point>;

Point point(const Vec3& v) { return {v.x, v.y, v.z}; }

/// A segment, whatever its direction.
Segment segment(const ContactTrace& trace) {
  return std::minmax(point(trace.from), point(trace.to));
}

bool is_segment(const ContactTrace& trace) { return trace.kind == ContactKind::segment; }

/// The segments of each curve.
std::vector<std::multiset<Segment>> segments_of_curves(const ContactGeometry& geometry) {
  std::vector<std::multiset<Segment>> curves;
  for (const ContactCurve& curve : geometry.curves) {
    curves.emplace_back();
    for (std::uint32_t i = 0; i < curve.count; ++i)
      curves.back().insert(segment(geometry.traces[geometry.steps[curve.first + i].trace]));
  }
  std::sort(curves.begin(), curves.end());
  return curves;
}

/// The patches, whichever of their sides comes first.
std::vector<std::tuple<std::uint32_t, float, int, int>> patches_of(
    const ContactGeometry& geometry) {
  std::vector<std::tuple<std::uint32_t, float, int, int>> patches;
  for (const ContactPatch& p : geometry.patches)
    patches.emplace_back(p.count, p.depth, std::min(p.joint_a, p.joint_b),
                         std::max(p.joint_a, p.joint_b));
  std::sort(patches.begin(), patches.end());
  return patches;
}

/// Consecutive segments have a common end, and each segment is in one curve.
void check_curves(const ContactGeometry& geometry) {
  std::set<std::uint32_t> seen;
  for (const ContactCurve& curve : geometry.curves) {
    const auto ends = [&](std::uint32_t i) {
      const CurveStep& step = geometry.steps[curve.first + i % curve.count];
      const ContactTrace& trace = geometry.traces[step.trace];
      return step.is_reversed ? std::pair(trace.to, trace.from) : std::pair(trace.from, trace.to);
    };
    for (std::uint32_t i = 0; i < curve.count; ++i) {
      const std::uint32_t trace = geometry.steps[curve.first + i].trace;
      EXPECT_TRUE(is_segment(geometry.traces[trace]));
      EXPECT_TRUE(seen.insert(trace).second);
      if (i + 1 < curve.count || curve.is_closed) {
        EXPECT_EQ(point(ends(i).second), point(ends(i + 1).first));
      }
    }
  }
  EXPECT_EQ(static_cast<std::ptrdiff_t>(seen.size()),
            std::count_if(geometry.traces.begin(), geometry.traces.end(), is_segment));
}

/// Steps after which the triangle numbers of a contact change their order: a triangle is the lower
/// one before and the higher one after, or the reverse.
std::size_t count_swaps(const ContactGeometry& geometry) {
  std::size_t swaps = 0;
  for (const ContactCurve& curve : geometry.curves)
    for (std::uint32_t i = 1; i < curve.count; ++i) {
      const auto contact = [&](std::uint32_t k) {
        return geometry.traces[geometry.steps[curve.first + k].trace].contact;
      };
      const Contact before = contact(i - 1), after = contact(i);
      swaps += before.triangle_a == after.triangle_b || before.triangle_b == after.triangle_a;
    }
  return swaps;
}

Shape shuffled(Random& random, Shape shape) {
  for (auto i = static_cast<std::uint32_t>(shape.triangles.size()); i > 1; --i)
    std::swap(shape.triangles[i - 1], shape.triangles[random.index(i)]);
  return shape;
}

/// Two shapes in one mesh, with triangles in random order.
Shape join(Random& random, const Shape& a, const Shape& b) {
  Shape both = a;
  const auto first = static_cast<std::uint32_t>(a.rest_positions.size());
  both.rest_positions.insert(both.rest_positions.end(), b.rest_positions.begin(),
                             b.rest_positions.end());
  for (const Triangle& t : b.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  for (const std::uint16_t joint : b.joints)
    both.joints.push_back(static_cast<std::uint16_t>(joint + a.joint_count));
  both.weights.insert(both.weights.end(), b.weights.begin(), b.weights.end());
  both.joint_count += b.joint_count;
  return shuffled(random, both);
}

/// Two closed parts of one mesh touch each other like two bodies.
TEST(SelfContact, OfTwoPartsEqualsThatOfTwoPoses) {
  Random random(40);
  const Shape limb_a = make_limb(24, 13, 4), limb_b = make_limb(24, 11, 4);
  Body both(join(random, limb_a, limb_b)), a(limb_a), b(limb_b);
  std::size_t curves = 0, hits = 0, swaps = 0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<Matrix4> palette_a = bend_limb(random, 4, 0.5, {0, 0, 0});
    const std::vector<Matrix4> palette_b = bend_limb(random, 4, 0.5, {0.11f, 0.05f, 0.07f});
    a.set(palette_a);
    b.set(palette_b);
    if (!geometry_of(a).traces.empty() || !geometry_of(b).traces.empty()) continue;
    std::vector<Matrix4> palette = palette_a;
    palette.insert(palette.end(), palette_b.begin(), palette_b.end());
    both.set(palette);
    Scratch scratch;
    std::vector<Contact> contacts;
    collide(a.pose, b.pose, scratch, contacts);
    ContactGeometry expected;
    describe_contacts(a.pose, b.pose, contacts, scratch, expected);

    const ContactGeometry geometry = geometry_of(both);
    check_curves(geometry);
    for (const ContactCurve& curve : geometry.curves) EXPECT_TRUE(curve.is_closed);
    ASSERT_EQ(segments_of_curves(geometry), segments_of_curves(expected));
    ASSERT_EQ(geometry.patches.size(), expected.patches.size());
    for (std::size_t p = 0; p < expected.patches.size(); ++p) {
      // The sides are numbered as in the first trace: joints below 4 belong to the first limb.
      const ContactPatch& patch = geometry.patches[p];
      const auto same = std::find_if(
          expected.patches.begin(), expected.patches.end(), [&](const ContactPatch& other) {
            return other.count == patch.count && std::abs(other.length - patch.length) < 1e-5f;
          });
      ASSERT_NE(same, expected.patches.end());
      const bool is_swapped = patch.joint_a >= 4;
      EXPECT_EQ(patch.depth, same->depth);
      EXPECT_EQ(is_swapped ? patch.joint_b : patch.joint_a, same->joint_a);
      EXPECT_EQ((is_swapped ? patch.joint_a : patch.joint_b) - 4, same->joint_b);
      const float sign = is_swapped ? -1.0f : 1.0f;
      EXPECT_NEAR(sign * patch.normal.x, same->normal.x, 1e-4f);
      EXPECT_NEAR(sign * patch.normal.y, same->normal.y, 1e-4f);
      EXPECT_NEAR(sign * patch.normal.z, same->normal.z, 1e-4f);
    }
    curves += geometry.curves.size();
    hits += !geometry.curves.empty();
    swaps += count_swaps(geometry);
  }
  EXPECT_GT(hits, 20u);
  EXPECT_GT(curves, hits);
  EXPECT_GT(swaps, 1000u);
}

/// The posed corners of a triangle.
detail::TriangleCorners corners_of(const Body& body, std::uint32_t triangle) {
  std::vector<Vec3> positions(body.shape.rest_positions.size());
  posed_vertices(body.pose, positions);
  const Triangle& t = body.shape.triangles[triangle];
  return {positions[t[0]], positions[t[1]], positions[t[2]]};
}

bool share_corner_at(const Body& body, const Contact& contact, const Vec3& position) {
  const auto is_corner = [&](std::uint32_t triangle) {
    const Triangle& t = body.shape.triangles[triangle];
    const detail::TriangleCorners corners = corners_of(body, triangle);
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] == position) return static_cast<std::ptrdiff_t>(t[k]);
    return std::ptrdiff_t{-1};
  };
  return is_corner(contact.triangle_a) >= 0 &&
         is_corner(contact.triangle_a) == is_corner(contact.triangle_b);
}

/// Curves from brute force: segments with a common end, unless its triangles share it, are one
/// curve.
std::vector<std::multiset<Segment>> chained_by_position(const Body& body,
                                                        const ContactGeometry& geometry) {
  std::vector<Segment> segments;
  std::vector<std::size_t> set;
  std::map<Point, std::size_t> seen;
  const auto join = [&](std::size_t from, std::size_t to) {
    const std::size_t old = set[from], merged = set[to];
    std::replace(set.begin(), set.end(), old, merged);
  };
  for (const ContactTrace& trace : geometry.traces) {
    const detail::TriangleCorners a = corners_of(body, trace.contact.triangle_a),
                                  b = corners_of(body, trace.contact.triangle_b);
    const detail::Crossing crossing = detail::cross_triangles(a, b);
    EXPECT_EQ(crossing.kind, detail::CrossingKind::segment);
    const Vec3 from = detail::crossing_position(crossing.ends[0], a, b);
    const Vec3 to = detail::crossing_position(crossing.ends[1], a, b);
    segments.push_back(std::minmax(point(from), point(to)));
    set.push_back(set.size());
    for (const Vec3& end : {from, to}) {
      if (share_corner_at(body, trace.contact, end)) continue;
      const auto [known, is_new] = seen.emplace(point(end), segments.size() - 1);
      if (!is_new) join(segments.size() - 1, known->second);
    }
  }
  std::map<std::size_t, std::multiset<Segment>> curves;
  for (std::size_t i = 0; i < segments.size(); ++i) curves[set[i]].insert(segments[i]);
  std::vector<std::multiset<Segment>> sorted;
  for (auto& [number, curve] : curves) sorted.push_back(std::move(curve));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

TEST(SelfContact, CurvesOfAFoldedLimbAreClosedOrEndAtSharedCorners) {
  Random random(41);
  Body body(shuffled(random, make_limb(30, 9, 6)));
  std::size_t closed = 0, open = 0, swaps = 0;
  for (int round = 0; round < 40; ++round) {
    body.set(bend_limb(random, 6, random.uniform(0.4, 1.4), {}));
    const ContactGeometry geometry = geometry_of(body);
    check_curves(geometry);
    ASSERT_EQ(segments_of_curves(geometry), chained_by_position(body, geometry));
    for (const ContactCurve& curve : geometry.curves) {
      ++(curve.is_closed ? closed : open);
      if (curve.is_closed) continue;
      const CurveStep& first = geometry.steps[curve.first];
      const CurveStep& last = geometry.steps[curve.first + curve.count - 1];
      const ContactTrace &begin = geometry.traces[first.trace], &end = geometry.traces[last.trace];
      EXPECT_TRUE(share_corner_at(body, begin.contact, first.is_reversed ? begin.to : begin.from));
      EXPECT_TRUE(share_corner_at(body, end.contact, last.is_reversed ? end.from : end.to));
    }
    swaps += count_swaps(geometry);
  }
  EXPECT_GT(closed, 3u);
  EXPECT_GT(open, 50u);
  EXPECT_GT(swaps, 500u);
}

TEST(SelfContact, DoesNotDependOnTheNumbersOfTriangles) {
  Random random(42);
  const Shape limb = make_limb(30, 9, 6);
  Shape reversed = limb;
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  Body a(limb), b(reversed), c(shuffled(random, limb));
  std::size_t patches = 0;
  for (int round = 0; round < 20; ++round) {
    const std::vector<Matrix4> palette = bend_limb(random, 6, random.uniform(0.4, 1.4), {});
    const ContactGeometry expected = [&] {
      a.set(palette);
      return geometry_of(a);
    }();
    for (Body* other : {&b, &c}) {
      other->set(palette);
      const ContactGeometry geometry = geometry_of(*other);
      ASSERT_EQ(segments_of_curves(geometry), segments_of_curves(expected));
      ASSERT_EQ(patches_of(geometry), patches_of(expected));
    }
    patches += expected.patches.size();
  }
  EXPECT_GT(patches, 20u);
}

TEST(SelfContact, OfTrianglesThatShareACornerStartsThere) {
  Body body(
      make_rigid({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1, -1}, {2, 1, 1}}, {{0, 1, 2}, {3, 4, 0}}));
  const ContactGeometry geometry = geometry_of(body);
  ASSERT_EQ(geometry.traces.size(), 1u);
  EXPECT_EQ(geometry.traces[0].kind, ContactKind::segment);
  EXPECT_EQ(segment(geometry.traces[0]), Segment(point({0, 0, 0}), point({2, 1, 0})));
  ASSERT_EQ(geometry.curves.size(), 1u);
  EXPECT_FALSE(geometry.curves[0].is_closed);
  ASSERT_EQ(geometry.patches.size(), 1u);
  EXPECT_FLOAT_EQ(geometry.patches[0].length, std::sqrt(5.0f));
}

TEST(SelfContact, CurvesDoNotContinueThroughSharedCorners) {
  // Two triangles stand on either side of two others, and all share corner 0.
  Body body(make_rigid({{0, 0, 0},
                        {4, 1, 0},
                        {4, -1, 0},
                        {-4, 1, 0},
                        {-4, -1, 0},
                        {2, 0, -1},
                        {2, 0, 1},
                        {-2, 0, -1},
                        {-2, 0, 1}},
                       {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {0, 7, 8}}));
  const ContactGeometry geometry = geometry_of(body);
  ASSERT_EQ(geometry.traces.size(), 2u);
  EXPECT_EQ(geometry.curves.size(), 2u);
  EXPECT_EQ(geometry.patches.size(), 2u);
}

TEST(SelfContact, DescribesFoldedDuplicateAndCollapsedTriangles) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {2, 0, 0}};
  const std::tuple<Triangle, Triangle, ContactKind> cases[] = {
      {{0, 1, 2}, {1, 0, 3}, ContactKind::coplanar},   // folded over an edge
      {{0, 1, 2}, {0, 1, 2}, ContactKind::coplanar},   // duplicates
      {{0, 1, 2}, {0, 3, 4}, ContactKind::coplanar},   // in one plane, share a corner
      {{0, 1, 2}, {0, 0, 3}, ContactKind::collapsed},  // a segment from a shared corner
      {{0, 1, 2}, {3, 3, 3}, ContactKind::collapsed},  // a point
      {{0, 1, 4}, {0, 1, 4}, ContactKind::collapsed},
  };
  for (const auto& [s, t, kind] : cases) {
    Body body(make_rigid(positions, {s, t}));
    const ContactGeometry geometry = geometry_of(body);
    ASSERT_EQ(geometry.traces.size(), 1u);
    EXPECT_EQ(geometry.traces[0].kind, kind);
    EXPECT_EQ(geometry.traces[0].from, geometry.traces[0].to);
    EXPECT_TRUE(geometry.curves.empty());
    EXPECT_EQ(geometry.patches.size(), 1u);
  }
}

TEST(SelfContact, OfASoupIsComplete) {
  Random random(43);
  std::set<ContactKind> kinds;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial}) {
      Body body(make_soup(random, 300, 5, 3, weights));
      body.set(make_palette(random, 5, motion, 0.2));
      const ContactGeometry geometry = geometry_of(body);
      EXPECT_GT(geometry.traces.size(), 20u);
      check_curves(geometry);
      EXPECT_EQ(geometry.members.size(), geometry.traces.size());
      for (const ContactTrace& trace : geometry.traces) kinds.insert(trace.kind);
    }
  EXPECT_TRUE(kinds.contains(ContactKind::segment) && kinds.contains(ContactKind::collapsed));
}

}  // namespace
}  // namespace pelt::test
