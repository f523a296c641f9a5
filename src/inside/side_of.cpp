/// A point is on the surface if it lies in the convex hull of the three posed corners of some
/// triangle, whether that is a triangle, a segment or a point. Elsewhere the surface winds around
/// it a definite number of times, and it is inside if that number is not zero.
///
/// The number is the sum of the signs with which a ray from the point pierces triangles, if the ray
/// meets no edge and no triangle that has collapsed. (The posed surface is a closed cycle, since
/// its edges cancel in pairs; its degree around the point is the number of signed preimages of any
/// direction whose preimages all lie within triangles that have not collapsed.) The ray of
/// geometry/generic_ray.hpp meets neither: all of them lie in finitely many planes through the
/// point, or lines, which it avoids. A triangle that has collapsed adds nothing, since it lies in
/// such a plane, and none that has the point in its plane is pierced. So one ray decides, every
/// triangle that it may pierce is decided by exact signs, and there is nothing to try again.

#include <pelt/inside.hpp>
#include <pelt/region.hpp>

#include "base/require.hpp"
#include "model/surface.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "ray/ray_traversal.hpp"

namespace pelt {
namespace {

bool is_far(const detail::RootBox& root, const Vec3& p) {
  return p.x < root.low[0] || root.high[0] < p.x || p.y < root.low[1] || root.high[1] < p.y ||
         p.z < root.low[2] || root.high[2] < p.z;
}

}  // namespace

QueryStats side_of(Pose& pose, const Surface& surface, const Vec3& point, Scratch& scratch,
                   PointSide& result) {
  detail::require(detail::is_surface_of(surface, pose),
                  "side_of: the surface is of another model than the pose");
  detail::require(surface.is_closed(), "side_of: the surface is not closed");
  const detail::PosedTree posed = pose.detail().posed_tree();
  QueryStats work;
  work.node_pairs = 1;
  result = PointSide::outside;
  if (is_far(detail::root_box(posed, work), point)) return work;
  const YesNo is_on = intersects(pose, Box{point, point}, scratch);
  work += is_on;
  if (is_on) {
    result = PointSide::on;
    return work;
  }
  int winding = 0;
  work += detail::winding_number(posed, point, winding);
  if (winding != 0) result = PointSide::inside;
  return work;
}

}  // namespace pelt
