/// A point is on the surface if it is in the convex hull of the three posed vertices of some
/// triangle, which may be a triangle, a segment or a point. For any other point, the surface has a
/// definite winding number, and the point is inside if this number is not zero.
///
/// The winding number is the sum of the signs with which a ray from the point pierces triangles, if
/// the ray meets no edge and no collapsed triangle. (The posed surface is a closed cycle, because
/// its edges cancel in pairs. Its degree around the point is the number of signed preimages of any
/// direction whose preimages are all inside triangles that have not collapsed.) The ray of
/// geometry/generic_ray.hpp meets neither: edges and collapsed triangles are in finitely many
/// planes or lines through the point, which the ray avoids. A collapsed triangle contributes
/// nothing, because it is in such a plane, and no triangle whose plane contains the point is
/// pierced. A single ray therefore decides, exact signs decide every triangle that it may pierce,
/// and no second attempt is needed.

#include <pelt/inside.hpp>
#include <pelt/solid.hpp>

#include "base/require.hpp"
#include "model/surface.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/valid_numbers.hpp"
#include "ray/ray_descent.hpp"

namespace pelt {
namespace {

/// Where a point is with respect to a surface.
struct Location {
  bool is_on = false;
  int winding = 0;  // 0 on the surface
};

QueryStats locate(Pose& pose, const Vec3& point, Scratch& scratch, Location& result) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  QueryStats work;
  work.node_pairs = 1;
  result = {};
  if (!contains(detail::root_box(posed, work), point)) return work;
  const YesNo is_on = intersects(pose, Box{point, point}, scratch);
  work += is_on;
  result.is_on = static_cast<bool>(is_on);
  if (!is_on)
    work += detail::winding_number(posed, point, detail::kGenericDirection, result.winding);
  return work;
}

}  // namespace

QueryStats side_of(Pose& pose, const Vec3& point, Scratch& scratch, PointSide& result) {
  detail::require(detail::surface_of(pose).is_closed, "side_of: the surface is not closed");
  detail::require(detail::is_finite(point), "side_of: the point is NaN or infinite");
  Location location;
  const QueryStats work = locate(pose, point, scratch, location);
  result = location.is_on          ? PointSide::on
           : location.winding != 0 ? PointSide::inside
                                   : PointSide::outside;
  return work;
}

QueryStats winding_number(Pose& pose, const Vec3& point, Scratch& scratch, std::int32_t& result) {
  detail::require(detail::surface_of(pose).is_closed, "winding_number: the surface is not closed");
  detail::require(detail::is_finite(point), "winding_number: the point is NaN or infinite");
  Location location;
  const QueryStats work = locate(pose, point, scratch, location);
  result = location.winding;
  return work;
}

namespace {

/// Whether all components of `inner` are inside `outer`. If the surfaces do not touch, all points
/// of a component are on the same side.
bool holds(Pose& outer, Pose& inner, Scratch& scratch, QueryStats& work) {
  if (!detail::surface_of(outer).is_closed) return false;
  detail::TriangleReader triangles(inner.detail().posed_tree());
  for (const std::uint32_t triangle : detail::surface_of(inner).components) {
    const Vec3 corner = triangles.corners(triangle, work)[0];
    PointSide side = PointSide::outside;
    work += side_of(outer, corner, scratch, side);
    if (side != PointSide::inside) return false;
  }
  return true;
}

}  // namespace

QueryStats containment(Pose& a, Pose& b, Scratch& scratch, Containment& result) {
  detail::require(&a != &b, "containment: `a` and `b` are the same pose; give two poses");
  result = Containment::none;
  const YesNo touch = intersects(a, b, scratch);
  QueryStats work = touch;
  if (touch) return work;
  if (holds(b, a, scratch, work)) {
    result = Containment::a_in_b;
  } else if (holds(a, b, scratch, work)) {
    result = Containment::b_in_a;
  }
  return work;
}

}  // namespace pelt
