#include <pelt/inside.hpp>

#include "base/require.hpp"
#include "model/surface.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"

namespace pelt {
namespace {

/// A pose with its surface, as callers name them.
struct Body {
  Pose& pose;
  const Surface& surface;
};

/// Whether all components of `inner` are inside `outer`. If the surfaces do not touch, all points
/// of a component are on the same side.
bool holds(const Body& outer, const Body& inner, Scratch& scratch, QueryStats& work) {
  if (!outer.surface.is_closed()) return false;
  detail::TriangleReader triangles(inner.pose.detail().posed_tree());
  for (const std::uint32_t triangle : inner.surface.detail().components) {
    const Vec3 corner = triangles.corners(triangle, work)[0];
    PointSide side = PointSide::outside;
    work += side_of(outer.pose, outer.surface, corner, scratch, side);
    if (side != PointSide::inside) return false;
  }
  return true;
}

}  // namespace

QueryStats containment(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                       Scratch& scratch, Containment& result) {
  detail::require(&a != &b, "containment: `a` and `b` are the same pose; give two poses");
  detail::require(detail::is_surface_of(surface_a, a) && detail::is_surface_of(surface_b, b),
                  "containment: a surface belongs to another model than its pose");
  const Body body_a = {a, surface_a}, body_b = {b, surface_b};
  result = Containment::none;
  const YesNo touch = intersects(a, b, scratch);
  QueryStats work = touch;
  if (touch) return work;
  if (holds(body_b, body_a, scratch, work)) {
    result = Containment::a_in_b;
  } else if (holds(body_a, body_b, scratch, work)) {
    result = Containment::b_in_a;
  }
  return work;
}

}  // namespace pelt
