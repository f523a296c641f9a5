#include <pelt/solid.hpp>

#include "fuzz/fuzzed_operands.hpp"
#include "fuzz/goal.hpp"
#include "fuzz/questions.hpp"
#include "geometry/exact_distance.hpp"
#include "motion/hulls_meet.hpp"
#include "solid/region_oracle.hpp"
#include "support/exact_winding.hpp"
#include "support/require.hpp"
#include "support/values.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace pelt::test {
namespace {

// Regions in rational numbers: which triangles touch a region, and which are wholly inside. Shares
// no idea with the library: a triangle is clipped at the planes of a region.

/// All points p with normal . p <= offset.
struct ExactHalfSpace {
  ExactVector normal;
  mpq_class offset;
};

class ExactRegion {
 public:
  explicit ExactRegion(const Region& region) {
    std::visit([this](const auto& shape) { add(shape); }, region);
  }

  bool touches(const detail::TriangleCorners& triangle) const {
    const ExactTriangle t = exact(triangle);
    return is_capsule_ ? capsule_touches(triangle) : !clipped(t).empty();
  }

  /// A region is convex, so that its corners decide.
  bool has_inside(const detail::TriangleCorners& triangle) const {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](const Vec3& corner) { return has_inside(exact(corner)); });
  }

 private:
  void add_face(const Vec3& normal, const mpq_class& offset) {
    faces_.push_back({exact(normal), offset});
  }

  void add(const HalfSpace& half) { add_face(half.normal, mpq_class(double{half.offset})); }

  void add(const ConvexPolyhedron& polyhedron) {
    for (const HalfSpace& face : polyhedron.faces()) add(face);
  }

  /// |axis . (p - centre)| <= half.
  void add_slab(const Vec3& axis, const ExactVector& centre, float half) {
    const mpq_class at = dot(exact(axis), centre);
    add_face(axis, mpq_class(at + double{half}));
    add_face({-axis.x, -axis.y, -axis.z}, mpq_class(double{half} - at));
  }

  void add(const OrientedBox& box) {
    const ExactVector centre = exact(box.centre);
    add_slab(box.axes[0], centre, box.half.x);
    add_slab(box.axes[1], centre, box.half.y);
    add_slab(box.axes[2], centre, box.half.z);
  }

  void add(const Box& box) {
    add(HalfSpace{{1, 0, 0}, box.high.x});
    add(HalfSpace{{0, 1, 0}, box.high.y});
    add(HalfSpace{{0, 0, 1}, box.high.z});
    add(HalfSpace{{-1, 0, 0}, -box.low.x});
    add(HalfSpace{{0, -1, 0}, -box.low.y});
    add(HalfSpace{{0, 0, -1}, -box.low.z});
  }

  void add(const Capsule& capsule) {
    is_capsule_ = true;
    capsule_ = capsule;
  }

  void add(const Sphere& sphere) { add(Capsule{sphere.centre, sphere.centre, sphere.radius}); }

  mpq_class squared_radius() const {
    const mpq_class radius(double{capsule_.radius});
    return radius * radius;
  }

  bool has_inside(const ExactVector& p) const {
    if (is_capsule_)
      return point_segment(p, exact(capsule_.a), exact(capsule_.b)) <= squared_radius();
    return std::all_of(faces_.begin(), faces_.end(), [&](const ExactHalfSpace& face) {
      return dot(face.normal, p) <= face.offset;
    });
  }

  bool capsule_touches(const detail::TriangleCorners& triangle) const {
    const detail::TriangleCorners segment = {capsule_.a, capsule_.b, capsule_.b};
    return hulls_meet<mpz_class>(big(triangle), big(segment)) ||
           triangle_triangle(exact(triangle), exact(segment)) <= squared_radius();
  }

  static BigTriangle big(const detail::TriangleCorners& t) {
    return {to_big(t[0]), to_big(t[1]), to_big(t[2])};
  }

  /// The corners of the part of the triangle in all half-spaces (Sutherland & Hodgman 1974).
  std::vector<ExactVector> clipped(const ExactTriangle& triangle) const {
    std::vector<ExactVector> corners(triangle.begin(), triangle.end());
    for (const ExactHalfSpace& face : faces_) {
      std::vector<ExactVector> kept;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const ExactVector &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const mpq_class over_p = dot(face.normal, p) - face.offset;
        const mpq_class over_q = dot(face.normal, q) - face.offset;
        if (over_p <= 0) kept.push_back(p);
        if (sgn(over_p) * sgn(over_q) < 0)
          kept.push_back(along(p, mpq_class(over_p / (over_p - over_q)), q - p));
      }
      corners = std::move(kept);
    }
    return corners;
  }

  std::vector<ExactHalfSpace> faces_;
  bool is_capsule_ = false;
  Capsule capsule_;
};

Goal regions_touched[] = {Goal("find_triangles: half-space"),   Goal("find_triangles: box"),
                          Goal("find_triangles: oriented box"), Goal("find_triangles: polyhedron"),
                          Goal("find_triangles: sphere"),       Goal("find_triangles: capsule")};
Goal region_missed("classify: outside"), region_crossed("classify: partly"),
    region_around("classify: inside");

/// The library's definition for one triangle against rational numbers.
void check_definition(const Region& region, const FuzzedBody& body,
                      const TrianglesInRegion& expected) {
  const ExactRegion exact_region(region);
  TrianglesInRegion found;
  for (std::uint32_t t = 0; t < body.triangle_count(); ++t) {
    if (exact_region.touches(body.corners(t))) found.intersecting.push_back(t);
    if (exact_region.has_inside(body.corners(t))) found.inside.push_back(t);
  }
  require(found.intersecting == expected.intersecting, "a triangle that touches a region");
  require(found.inside == expected.inside, "a triangle inside a region");
}

}  // namespace

void ask_region(Question& q) {
  const Region region = make_region(q.bytes, q.a);
  const TrianglesInRegion expected = brute_force(region, q.a.shape.triangles, q.a.posed);
  if (q.a.is_small()) check_definition(region, q.a, expected);
  TrianglesInRegion found;
  find_triangles(q.a.pose, region, q.scratch, found);
  require(found.intersecting == expected.intersecting && found.inside == expected.inside,
          "find_triangles");
  std::vector<std::uint32_t> touching;
  collide(q.a.pose, region, q.scratch, touching);
  require(touching == expected.intersecting, "collide with a region");
  require(static_cast<bool>(intersects(q.a.pose, region, q.scratch)) == !touching.empty(),
          "intersects of a region");
  const Placement placement = placement_of(q.a.pose, region, q.scratch);
  require(placement == placement_of(expected, q.a.triangle_count()), "classify");
  regions_touched[region.index()].reach(!touching.empty());
  region_missed.reach(placement == Placement::outside);
  region_crossed.reach(placement == Placement::partly);
  region_around.reach(placement == Placement::inside);
}

}  // namespace pelt::test
