#include "contact/traces.hpp"
#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "contact/triangle_crossing.hpp"
#include "geometry/ray_triangle.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pelt::detail {
namespace {

FeatureName name_of(OpenFeature feature, std::uint32_t triangle, const Surface& surface) {
  if (feature == OpenFeature::face) return {triangle, 0, 2};
  const Triangle& corners = surface.corners[triangle];
  const auto number = static_cast<std::size_t>(feature);
  if (feature <= OpenFeature::corner2) return {corners[number], 0, 0};
  const auto [less, more] = std::minmax(corners[number - 3], corners[(number - 2) % 3]);
  return {less, more, 1};
}

}  // namespace

EndKey key_of(const CrossingEnd& end, const Contact& contact, const ContactSurfaces& surfaces) {
  EndKey key = {name_of(end.a, contact.triangle_a, surfaces.a),
                name_of(end.b, contact.triangle_b, surfaces.b)};
  key.is_swapped = surfaces.is_self && key.second < key.first;
  if (key.is_swapped) std::swap(key.first, key.second);
  return key;
}

namespace {

/// Normalises a vector; zero stays zero.
Vec3d unit(const Vec3d& v) {
  const double length = std::sqrt(squared_length(v));
  return length > 0 ? (1 / length) * v : Vec3d();
}

Vec3d centre(const TriangleCorners& t) {
  return (1.0 / 3) * (Vec3d(t[0]) + Vec3d(t[1]) + Vec3d(t[2]));
}

/// In one plane, normals are equal or opposite, and n_b - n_a has the direction of n_b or is zero.
/// Equal normals differ by rounding once they are computed, and their difference has any direction.
Vec3d leaving_direction(const TriangleCorners& a, const TriangleCorners& b, ContactKind kind) {
  const Vec3d normal_b = unit(area_vector(b));
  if (kind == ContactKind::coplanar) return normal_b;
  const Vec3d between = unit(normal_b - unit(area_vector(a)));
  return squared_length(between) > 0 ? between : normal_b;
}

/// The distance by which b extends beyond the start of a along a direction. The triangles touch, so
/// a negative difference is rounding.
double depth_along(const Vec3d& direction, const TriangleCorners& a, const TriangleCorners& b) {
  const auto at = [&](const Vec3& p) { return dot(direction, Vec3d(p)); };
  const double end_of_b = std::max({at(b[0]), at(b[1]), at(b[2])});
  return std::max(end_of_b - std::min({at(a[0]), at(a[1]), at(a[2])}), 0.0);
}

/// Positions depend on the order of the features, by rounding.
Vec3 position_of(const CrossingEnd& end, const EndKey& key, const ContactCorners& corners) {
  return key.is_swapped ? crossing_position({end.b, end.a}, corners.b, corners.a)
                        : crossing_position(end, corners.a, corners.b);
}

ContactKind kind_of(const Crossing& crossing) {
  switch (crossing.kind) {
    case CrossingKind::segment:
      return ContactKind::segment;
    case CrossingKind::point:
      return ContactKind::point;
    case CrossingKind::coplanar:
      return ContactKind::coplanar;
    case CrossingKind::collapsed:
      return ContactKind::collapsed;
    case CrossingKind::none:
      break;
  }
  PELT_ASSERT(false);  // not a contact of these poses
  return ContactKind::collapsed;
}

}  // namespace

ContactTrace trace_of(const Contact& contact, const ContactCorners& corners,
                      const ContactSurfaces& surfaces, std::array<EndKey, 2>& ends) {
  const auto& [corners_a, corners_b] = corners;
  const Crossing crossing = cross_triangles(corners_a, corners_b);
  ContactTrace trace;
  trace.contact = contact;
  trace.kind = kind_of(crossing);
  if (trace.kind == ContactKind::segment || trace.kind == ContactKind::point) {
    for (const std::size_t i : {0u, 1u}) ends[i] = key_of(crossing.ends[i], contact, surfaces);
    trace.from = position_of(crossing.ends[0], ends[0], corners);
    trace.to = position_of(crossing.ends[1], ends[1], corners);
  } else {
    trace.from = trace.to = to_float(0.5 * (centre(corners_a) + centre(corners_b)));
  }
  const Vec3d normal = leaving_direction(corners_a, corners_b, trace.kind);
  trace.normal = to_float(normal);
  trace.depth = static_cast<float>(depth_along(normal, corners_a, corners_b));
  trace.joint_a = surfaces.a.joints[contact.triangle_a];
  trace.joint_b = surfaces.b.joints[contact.triangle_b];
  return trace;
}

double length_of(const ContactTrace& trace) {
  return std::sqrt(squared_length(Vec3d(trace.to) - Vec3d(trace.from)));
}

}  // namespace pelt::detail
