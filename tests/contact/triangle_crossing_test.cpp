/// Which features of two triangles intersect, and where, against CGAL's exact constructions.
#include "contact/triangle_crossing.hpp"

#include "geometry/triangle_cases.hpp"
#include "geometry/triangle_pair.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <vector>

namespace pelt::test {
namespace {

using detail::Crossing;
using detail::CrossingEnd;
using detail::CrossingKind;
using detail::OpenFeature;
using detail::TriangleCorners;

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point3 = Kernel::Point_3;
using Triangle3 = Kernel::Triangle_3;

Point3 cgal(const Vec3& p) { return {p.x, p.y, p.z}; }
Triangle3 cgal(const TriangleCorners& t) { return {cgal(t[0]), cgal(t[1]), cgal(t[2])}; }

/// The ends of the intersection by CGAL; empty unless it is a point or a segment.
std::vector<Point3> ends_by_cgal(const Triangle3& a, const Triangle3& b) {
  const auto found = CGAL::intersection(a, b);
  if (!found) return {};
  if (const auto* point = boost::get<Point3>(&*found)) return {*point, *point};
  if (const auto* segment = boost::get<Kernel::Segment_3>(&*found))
    return {segment->source(), segment->target()};
  return {};
}

/// The feature of a triangle that contains a point of it.
OpenFeature feature_at(const Triangle3& t, const Point3& p) {
  for (int i = 0; i < 3; ++i)
    if (t.vertex(i) == p) return detail::corner_feature(static_cast<std::size_t>(i));
  for (int i = 0; i < 3; ++i)
    if (CGAL::collinear(t.vertex(i), t.vertex(i + 1), p))
      return detail::edge_feature(static_cast<std::size_t>(i));
  return OpenFeature::face;
}

/// The largest distance along an axis.
double distance(const Point3& p, const Vec3& q) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis)
    most = std::max(most, std::abs(CGAL::to_double(p[axis] - cgal(q)[axis])));
  return most;
}

double extent(const TriangleCorners& t) {
  double most = 0;
  for (const Vec3& p : t)
    for (const float c : {p.x, p.y, p.z}) most = std::max(most, std::abs(static_cast<double>(c)));
  return most;
}

struct Seen {
  std::map<CrossingKind, int> kinds;
  std::map<std::pair<bool, bool>, int> on_faces;  // whether the end lies within a's face, b's
  double worst_error = 0;
};

void check_ends(const TriangleCorners& a, const TriangleCorners& b, const Crossing& crossing,
                Seen& seen) {
  const Triangle3 cgal_a = cgal(a), cgal_b = cgal(b);
  std::vector<Point3> expected = ends_by_cgal(cgal_a, cgal_b);
  ASSERT_EQ(expected.size(), 2u);
  const Kernel::Vector_3 direction =
      CGAL::cross_product(CGAL::normal(cgal_a.vertex(0), cgal_a.vertex(1), cgal_a.vertex(2)),
                          CGAL::normal(cgal_b.vertex(0), cgal_b.vertex(1), cgal_b.vertex(2)));
  if ((expected[1] - expected[0]) * direction < 0) std::swap(expected[0], expected[1]);
  EXPECT_EQ(crossing.kind == CrossingKind::point, expected[0] == expected[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    const CrossingEnd& end = crossing.ends[i];
    EXPECT_EQ(end.a, feature_at(cgal_a, expected[i])) << "end " << i;
    EXPECT_EQ(end.b, feature_at(cgal_b, expected[i])) << "end " << i;
    ++seen.on_faces[{end.a == OpenFeature::face, end.b == OpenFeature::face}];
    const double error = distance(expected[i], detail::crossing_position(end, a, b)) /
                         std::max(extent(a), extent(b));
    seen.worst_error = std::max(seen.worst_error, error);
  }
}

/// Compares `pairs` pairs from `make`.
Seen compare_with_cgal(IntegerPair (*make)(Random&), std::uint64_t seed, int pairs) {
  Random random(seed);
  Seen seen;
  for (int i = 0; i < pairs && !testing::Test::HasFailure(); ++i) {
    const IntegerPair pair = make(random);
    const TriangleCorners a = scaled(pair.a, -24), b = scaled(pair.b, -24);
    SCOPED_TRACE("pair " + std::to_string(i) + " of seed " + std::to_string(seed) + ": " +
                 to_text(a) + to_text(b));
    const Crossing crossing = detail::cross_triangles(a, b);
    ++seen.kinds[crossing.kind];
    EXPECT_EQ(crossing.kind != CrossingKind::none, detail::triangles_intersect(a, b));
    if (crossing.kind == CrossingKind::none) continue;
    const bool collapsed = detail::has_collapsed(a) || detail::has_collapsed(b);
    EXPECT_EQ(collapsed, cgal(a).is_degenerate() || cgal(b).is_degenerate());
    EXPECT_EQ(crossing.kind == CrossingKind::collapsed, collapsed);
    if (crossing.kind == CrossingKind::segment || crossing.kind == CrossingKind::point)
      check_ends(a, b, crossing, seen);
  }
  std::cout << "seed " << seed << ": " << seen.kinds[CrossingKind::segment] << " segments, "
            << seen.kinds[CrossingKind::point] << " points, " << seen.kinds[CrossingKind::coplanar]
            << " coplanar, " << seen.kinds[CrossingKind::collapsed] << " collapsed, error "
            << seen.worst_error << '\n';
  EXPECT_LT(seen.worst_error, 0x1p-23);
  return seen;
}

TEST(TriangleCrossing, Anywhere) {
  Seen seen = compare_with_cgal(anywhere, 71, 30'000);
  EXPECT_GT(seen.kinds[CrossingKind::segment], 1'000);
}

TEST(TriangleCrossing, OnGrid) {
  Seen seen = compare_with_cgal(on_grid, 72, 30'000);
  for (const CrossingKind kind : {CrossingKind::segment, CrossingKind::point,
                                  CrossingKind::coplanar, CrossingKind::collapsed})
    EXPECT_GT(seen.kinds[kind], 100) << static_cast<int>(kind);
  EXPECT_GT((seen.on_faces[{false, false}]), 1'000);
}

TEST(TriangleCrossing, ShearedGrid) {
  Seen seen = compare_with_cgal(sheared_grid, 73, 10'000);
  EXPECT_GT((seen.on_faces[{false, true}]) + (seen.on_faces[{true, false}]), 100);
}

TEST(TriangleCrossing, NearlyCoplanar) { compare_with_cgal(nearly_coplanar, 74, 20'000); }

TEST(TriangleCrossing, IsPlacedAlikeForTrianglesThatShareAnEdge) {
  const Vec3 from = {0.1f, -0.3f, 0.7f}, to = {0.2f, 0.4f, -0.9f};
  const TriangleCorners face = {{{-3, -3, 0.1f}, {3, -2, 0}, {0, 4, -0.2f}}};
  const TriangleCorners left = {{from, to, {-1, 0, 0}}}, right = {{to, from, {1.5f, 0.5f, 0.25f}}};
  const auto position = [&](const TriangleCorners& t) {
    return detail::crossing_position({OpenFeature::edge0, OpenFeature::face}, t, face);
  };
  EXPECT_EQ(position(left), position(right));
}

}  // namespace
}  // namespace pelt::test
