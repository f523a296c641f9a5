#include <pelt/surface.hpp>

#include "base/vec3.hpp"
#include "support/closed_shapes.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pelt::test {
namespace {

using detail::Vec3d;

/// A posed model.
struct Body {
  explicit Body(const Shape& shape) : Body(*build_model(shape.view())) {}
  explicit Body(const SkinnedModel& model) : pose(model) {}

  void set(const std::vector<Matrix4>& palette) { ASSERT_TRUE(pose.set_palette(palette)); }

  Pose pose;
};

ContactGeometry geometry_of(Body& a, Body& b) {
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a.pose, b.pose, scratch, contacts);
  ContactGeometry geometry;
  describe_contacts(a.pose, b.pose, contacts, scratch, geometry);
  EXPECT_EQ(geometry.traces.size(), contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    EXPECT_EQ(geometry.traces[i].contact, contacts[i]);
  return geometry;
}

std::size_t count_of(const ContactGeometry& geometry, ContactKind kind) {
  return static_cast<std::size_t>(
      std::count_if(geometry.traces.begin(), geometry.traces.end(),
                    [&](const ContactTrace& trace) { return trace.kind == kind; }));
}

/// The start and the end of a step.
std::pair<Vec3, Vec3> ends_of(const ContactGeometry& geometry, const CurveStep& step) {
  const ContactTrace& trace = geometry.traces[step.trace];
  return step.is_reversed ? std::pair(trace.to, trace.from) : std::pair(trace.from, trace.to);
}

/// All segments are in curves, each once, and consecutive ends are bitwise equal.
void check_curves(const ContactGeometry& geometry) {
  std::set<std::uint32_t> seen;
  for (const ContactCurve& curve : geometry.curves) {
    ASSERT_GT(curve.count, 0u);
    const auto step = [&](std::uint32_t i) { return geometry.steps[curve.first + i]; };
    for (std::uint32_t i = 0; i < curve.count; ++i) {
      EXPECT_EQ(geometry.traces[step(i).trace].kind, ContactKind::segment);
      EXPECT_TRUE(seen.insert(step(i).trace).second) << step(i).trace;
      if (i + 1 < curve.count || curve.is_closed) {
        EXPECT_EQ(ends_of(geometry, step(i)).second,
                  ends_of(geometry, step((i + 1) % curve.count)).first);
      }
    }
  }
  EXPECT_EQ(seen.size(), count_of(geometry, ContactKind::segment));
  EXPECT_EQ(seen.size(), geometry.steps.size());
}

/// All traces are in patches, each once; the traces of a curve are in one patch.
void check_patches(const ContactGeometry& geometry) {
  std::vector<std::size_t> patch_of(geometry.traces.size(), SIZE_MAX);
  for (std::size_t r = 0; r < geometry.patches.size(); ++r) {
    const ContactPatch& patch = geometry.patches[r];
    if (r > 0) {
      EXPECT_LE(patch.count, geometry.patches[r - 1].count);
    }
    for (std::uint32_t i = 0; i < patch.count; ++i) {
      const std::uint32_t member = geometry.members[patch.first + i];
      EXPECT_EQ(patch_of[member], SIZE_MAX);
      patch_of[member] = r;
      EXPECT_LE(geometry.traces[member].depth, patch.depth);
    }
  }
  EXPECT_EQ(std::count(patch_of.begin(), patch_of.end(), SIZE_MAX), 0);
  for (const ContactCurve& curve : geometry.curves)
    for (std::uint32_t i = 0; i < curve.count; ++i)
      EXPECT_EQ(patch_of[geometry.steps[curve.first + i].trace],
                patch_of[geometry.steps[curve.first].trace]);
}

TEST(Contact, CurvesOfClosedSurfacesAreClosed) {
  Random random(5);
  Body a(make_limb(24, 13, 4)), b(make_limb(24, 11, 4));
  ASSERT_TRUE(a.pose.model().surface().is_closed() && b.pose.model().surface().is_closed());
  std::size_t curves = 0, hits = 0;
  for (int i = 0; i < 60; ++i) {
    a.set(bend_limb(random, 4, 0.7, {0, 0, 0}));
    b.set(bend_limb(random, 4, 0.7, {0.11f, 0.05f, 0.07f}));
    const ContactGeometry geometry = geometry_of(a, b);
    EXPECT_EQ(count_of(geometry, ContactKind::segment), geometry.traces.size());
    check_curves(geometry);
    check_patches(geometry);
    for (const ContactCurve& curve : geometry.curves) EXPECT_TRUE(curve.is_closed);
    curves += geometry.curves.size();
    hits += !geometry.curves.empty();
  }
  EXPECT_GT(hits, 20u);
  EXPECT_GT(curves, hits);
}

TEST(Contact, WalksCurvesOfOrientedSurfacesInOneDirection) {
  Random random(6);
  Body a(make_limb(24, 13, 4)), b(make_limb(24, 11, 4));
  a.set(bend_limb(random, 4, 0.3, {0, 0, 0}));
  b.set(bend_limb(random, 4, 0.3, {0.11f, 0.05f, 0.07f}));
  const ContactGeometry geometry = geometry_of(a, b);
  ASSERT_FALSE(geometry.curves.empty());
  for (const ContactCurve& curve : geometry.curves)
    for (std::uint32_t i = 0; i < curve.count; ++i)
      EXPECT_EQ(geometry.steps[curve.first + i].is_reversed,
                geometry.steps[curve.first].is_reversed);
}

TEST(Contact, CurvesEndAtABorder) {
  Shape square;  // two triangles in the plane y = 0
  square.rest_positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  square.influences_per_vertex = 1;
  square.joints = {0, 0, 0, 0};
  square.weights = {1, 1, 1, 1};
  Shape upright = square;  // in the plane x = 0.25, and extending beyond the border of the other
  upright.rest_positions = {{0.25f, -1, -3}, {0.25f, 1, -3}, {0.25f, 1, 2.5f}, {0.25f, -1, 2.5f}};
  Body a(square), b(upright);
  const ContactGeometry geometry = geometry_of(a, b);
  check_curves(geometry);
  check_patches(geometry);
  ASSERT_EQ(geometry.curves.size(), 1u);
  EXPECT_FALSE(geometry.curves[0].is_closed);
  EXPECT_FLOAT_EQ(geometry.curves[0].length, 2);
  EXPECT_EQ(geometry.curves[0].area, 0);
  const ContactCurve& curve = geometry.curves[0];
  const Vec3 begin = ends_of(geometry, geometry.steps[curve.first]).first;
  const Vec3 end = ends_of(geometry, geometry.steps[curve.first + curve.count - 1]).second;
  EXPECT_EQ(std::min(begin.z, end.z), -1);
  EXPECT_EQ(std::max(begin.z, end.z), 1);
  EXPECT_FLOAT_EQ(geometry.patches[0].length, 2);
  EXPECT_FLOAT_EQ(geometry.patches[0].point.x, 0.25f);
}

TEST(Contact, MeasuresCurves) {
  Body cube(make_cube(1, {0, 0, 0})), through_a_side(make_cube(0.5f, {0.1f, 0.2f, 1.1f}));
  const ContactGeometry square = geometry_of(cube, through_a_side);
  ASSERT_EQ(square.curves.size(), 1u);
  EXPECT_TRUE(square.curves[0].is_closed);
  EXPECT_NEAR(square.curves[0].length, 4, 1e-6);
  EXPECT_NEAR(square.curves[0].area, 1, 1e-6);

  Body sphere(make_sphere(1, 5)), other(make_sphere(1, 5));
  other.set({rotation_about({1, 2, 3}, 0.3, {0, 0, 0}, {1, 0, 0})});
  const ContactGeometry circle = geometry_of(sphere, other);
  const double pi = 3.14159265358979323846, radius = std::sqrt(0.75);
  ASSERT_EQ(circle.curves.size(), 1u);
  EXPECT_NEAR(circle.curves[0].length, 2 * pi * radius, 0.02);
  EXPECT_NEAR(circle.curves[0].area, pi * radius * radius, 0.02);
}

/// The definition, in plain doubles.
void check_measures(const ContactGeometry& geometry, const ContactCurve& curve) {
  double length = 0;
  Vec3d area;
  for (std::uint32_t i = 0; i < curve.count; ++i) {
    const auto [from, to] = ends_of(geometry, geometry.steps[curve.first + i]);
    length += std::sqrt(squared_length(Vec3d(to) - Vec3d(from)));
    area = area + 0.5 * cross(Vec3d(from), Vec3d(to));
  }
  EXPECT_NEAR(curve.length, length, 1e-6 * length);
  const double expected = curve.is_closed ? std::sqrt(squared_length(area)) : 0;
  EXPECT_NEAR(curve.area, expected, 1e-6 * length * length);
  EXPECT_LE(curve.area, length * length / (4 * 3.14159)) << "a circle encloses most";
}

TEST(Contact, MeasuresAllCurvesByTheirDefinition) {
  Random random(9);
  Body a(make_limb(24, 13, 4)), b(make_limb(24, 11, 4));
  std::size_t curves = 0;
  for (int i = 0; i < 40; ++i) {
    a.set(bend_limb(random, 4, 0.7, {0, 0, 0}));
    b.set(bend_limb(random, 4, 0.7, {0.11f, 0.05f, 0.07f}));
    const ContactGeometry geometry = geometry_of(a, b);
    for (const ContactCurve& curve : geometry.curves) check_measures(geometry, curve);
    curves += geometry.curves.size();
  }
  EXPECT_GT(curves, 30u);
}

TEST(Contact, MeasuresHowDeepATriangleReachesBehindTheOther) {
  Shape below;  // its front faces up
  below.rest_positions = {{-5, 0, -5}, {0, 0, 8}, {5, 0, -5}};
  below.triangles = {{0, 1, 2}};
  below.influences_per_vertex = 1;
  below.joints = {0, 0, 0};
  below.weights = {1, 1, 1};
  Shape above = below;  // an upright triangle that reaches 0.25 below, seen from +x
  above.rest_positions = {{0, 1, -1}, {0, 1, 1}, {0, -0.25f, 0}};
  Body a(above), b(below);
  const ContactGeometry geometry = geometry_of(a, b);
  ASSERT_EQ(geometry.traces.size(), 1u);
  const ContactTrace& trace = geometry.traces[0];
  EXPECT_EQ(trace.kind, ContactKind::segment);
  EXPECT_NEAR(std::abs(trace.from.z - trace.to.z), 0.4, 1e-6);
  EXPECT_NEAR(trace.normal.y, std::sqrt(0.5), 1e-6);  // between straight up and sideways
  const Vec3d moved = static_cast<double>(trace.depth) * Vec3d(trace.normal);
  a.set({rotation_about({1, 0, 0}, 0, {0, 0, 0}, detail::to_float(1.001 * moved))});
  EXPECT_TRUE(geometry_of(a, b).traces.empty());
}

/// A square of side 2 about the origin, in `cells` x `cells` pairs of triangles. `upright`: in the
/// plane x = 0, otherwise in y = 0.
Shape square(int cells, bool upright) {
  Shape shape;
  const auto side = static_cast<std::uint32_t>(cells) + 1;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const float u = 2.0f * static_cast<float>(i % side) / static_cast<float>(cells) - 1;
    const float v = 2.0f * static_cast<float>(i / side) / static_cast<float>(cells) - 1;
    shape.rest_positions.push_back(upright ? Vec3{0, u + 0.5f, v} : Vec3{u, 0, v});
  }
  for (std::uint32_t i = 0; i < side * (side - 1); ++i) {
    if (i % side + 1 == side) continue;
    shape.triangles.push_back({i, i + side, i + 1});
    shape.triangles.push_back({i + 1, i + side, i + side + 1});
  }
  return make_rigid(shape.rest_positions, shape.triangles);
}

TEST(Contact, LengthOfAPatchDoesNotDependOnTheSizeOfTriangles) {
  float depth_before = 10;
  for (const int cells : {1, 3, 9, 27}) {  // odd: no edge lies in the other square
    Body a(square(cells, true)), b(square(cells, false));
    const ContactGeometry geometry = geometry_of(a, b);
    ASSERT_EQ(geometry.patches.size(), 1u) << cells;
    const ContactPatch& patch = geometry.patches[0];
    EXPECT_NEAR(patch.length, 2, 1e-5) << cells;
    EXPECT_LT(patch.depth, 0.8f * depth_before) << cells;
    depth_before = patch.depth;
  }
}

TEST(Contact, DescribesCoplanarAndCollapsedTriangles) {
  const Shape flat = make_rigid({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {1, 1, 2}},
                                {{0, 1, 2}, {3, 4, 5}});
  Shape one = flat;
  one.triangles = {{0, 2, 1}};
  Body a(flat), b(one);
  const ContactGeometry geometry = geometry_of(a, b);
  ASSERT_EQ(geometry.traces.size(), 2u);
  EXPECT_EQ(geometry.traces[0].kind, ContactKind::coplanar);
  EXPECT_EQ(geometry.traces[0].normal, (Vec3{0, 0, -1}));
  EXPECT_EQ(geometry.traces[0].depth, 0);
  EXPECT_EQ(geometry.traces[1].kind, ContactKind::collapsed);
  EXPECT_TRUE(geometry.curves.empty());
  check_patches(geometry);
}

/// Returns the corners of `count` triangles that have not collapsed, in the plane of u and v.
std::vector<Vec3> corners_in_plane(Random& random, std::size_t count, const Vec3d& u,
                                   const Vec3d& v) {
  std::vector<Vec3> corners;
  while (corners.size() < 3 * count) {
    std::array<Vec3d, 3> c;
    for (Vec3d& corner : c)
      corner = (random.index(9) - 4.0) * u + (random.index(9) - 4.0) * v + Vec3d(Vec3{64, 0, 0});
    if (squared_length(cross(c[1] - c[0], c[2] - c[0])) == 0) continue;
    for (const Vec3d& corner : c) corners.push_back(detail::to_float(corner));
  }
  return corners;
}

Vec3d normal_of(const Shape& shape, std::uint32_t triangle) {
  std::array<Vec3d, 3> c;
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = Vec3d(shape.rest_positions[shape.triangles[triangle][k]]);
  const Vec3d normal = cross(c[1] - c[0], c[2] - c[0]);
  return (1 / std::sqrt(squared_length(normal))) * normal;
}

/// Unit normals that are equal differ by rounding once they are computed.
TEST(Contact, InOnePlaneTheNormalIsThatOfB) {
  Random random(22);
  const std::array<Vec3d, 3> edges = {Vec3d(Vec3{1, 0, 1}), Vec3d(Vec3{2, 1, 0}),
                                      Vec3d(Vec3{1, 2, 3})};
  std::size_t equal = 0, opposite = 0;
  for (std::size_t round = 0; round < 3; ++round) {
    std::array<Shape, 2> shapes;
    for (Shape& shape : shapes) {
      shape = make_rigid(corners_in_plane(random, 30, edges[round], edges[(round + 1) % 3]), {});
      for (std::uint32_t i = 0; i < 90; i += 3) shape.triangles.push_back({i, i + 1, i + 2});
    }
    Body a(shapes[0]), b(shapes[1]);
    for (const ContactTrace& trace : geometry_of(a, b).traces) {
      const Vec3d n_a = normal_of(shapes[0], trace.contact.triangle_a);
      const Vec3d n_b = normal_of(shapes[1], trace.contact.triangle_b);
      EXPECT_EQ(trace.kind, ContactKind::coplanar);
      EXPECT_LT(squared_length(Vec3d(trace.normal) - n_b), 1e-12);
      EXPECT_TRUE(trace.depth >= 0 && trace.depth < 1e-12f) << trace.depth;
      ++(dot(n_a, n_b) > 0 ? equal : opposite);
    }
  }
  EXPECT_GT(equal, 500u);
  EXPECT_GT(opposite, 500u);
}

using Corners = std::array<Vec3d, 3>;

std::vector<Corners> posed_corners(const Shape& shape, const Body& body) {
  std::vector<Vec3> posed(shape.rest_positions.size());
  posed_vertices(body.pose, posed);
  std::vector<Corners> corners;
  for (const auto& [i, j, k] : shape.triangles)
    corners.push_back({Vec3d(posed[i]), Vec3d(posed[j]), Vec3d(posed[k])});
  return corners;
}

/// The depth is that of the definition, within the error that the header states.
void check_depth(const ContactTrace& trace, const Corners& a, const Corners& b) {
  const Vec3d normal(trace.normal);
  double longest = 0, overlap = -HUGE_VAL;
  for (const Vec3d& p : a)
    for (const Vec3d& q : b) {
      longest = std::max(longest, squared_length(q - p));
      overlap = std::max(overlap, dot(normal, q - p));
    }
  for (const Corners& t : {a, b})
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, squared_length(t[(k + 1) % 3] - t[k]));
  EXPECT_GE(trace.depth, 0);
  EXPECT_LT(std::abs(double{trace.depth} - overlap), 0x1p-23 * std::sqrt(longest));
}

TEST(Contact, OfASoupIsComplete) {
  Random random(7);
  const Shape shape_a = make_soup(random, 400, 5, 3, Weights::random);
  const Shape shape_b = make_soup(random, 300, 4, 4, Weights::adversarial);
  Body a(shape_a), b(shape_b);
  std::set<ContactKind> kinds;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed}) {
    a.set(make_palette(random, 5, motion, 0.2));
    b.set(make_palette(random, 4, motion, 0.2));
    const ContactGeometry geometry = geometry_of(a, b);
    EXPECT_GT(geometry.traces.size(), 100u);
    check_curves(geometry);
    check_patches(geometry);
    const std::vector<Corners> corners_a = posed_corners(shape_a, a);
    const std::vector<Corners> corners_b = posed_corners(shape_b, b);
    for (const ContactTrace& trace : geometry.traces) {
      check_depth(trace, corners_a[trace.contact.triangle_a], corners_b[trace.contact.triangle_b]);
      kinds.insert(trace.kind);
    }
  }
  EXPECT_TRUE(kinds.contains(ContactKind::segment) && kinds.contains(ContactKind::collapsed));
}

}  // namespace
}  // namespace pelt::test
