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

#include "inside/side_of.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "ray/ray_traversal.hpp"
#include "region/region_descent.hpp"

namespace pelt {
namespace detail {
namespace {

bool is_far(const RootBox& root, const Vec3& p) {
  return p.x < root.low[0] || root.high[0] < p.x || p.y < root.low[1] || root.high[1] < p.y ||
         p.z < root.low[2] || root.high[2] < p.z;
}

}  // namespace

QueryStats touches_box(pelt::Pose& pose, const Box& box, pelt::Scratch& scratch, bool& touches) {
  const RegionAnswer answer = descend_in_faces(
      pose.detail().posed_tree(), PreparedRegion(box).faces, scratch.detail(), RegionWish::touch);
  touches = answer.touches;
  return answer.work;
}

QueryStats find_side(pelt::Pose& pose, const pelt::Surface& surface, const Vec3& point,
                     pelt::Scratch& scratch, PointSide& side) {
  PELT_ASSERT(surface.is_closed());
  PELT_ASSERT(&pose.model().detail() == &surface.model().detail());
  const PosedTree posed = pose.detail().posed_tree();
  QueryStats work;
  work.node_pairs = 1;
  side = PointSide::outside;
  if (is_far(root_box(posed, work), point)) return work;
  bool is_on = false;
  work += touches_box(pose, {point, point}, scratch, is_on);
  if (is_on) {
    side = PointSide::on;
    return work;
  }
  int winding = 0;
  work += winding_number(posed, point, winding);
  if (winding != 0) side = PointSide::inside;
  return work;
}

}  // namespace detail

PointSide side_of(Pose& pose, const Surface& surface, const Vec3& point, Scratch& scratch) {
  PointSide side;
  detail::find_side(pose, surface, point, scratch, side);
  return side;
}

}  // namespace pelt
