#include "inside/containment.hpp"

#include "base/assert.hpp"
#include "collide/pair_traversal.hpp"
#include "contact/traces.hpp"
#include "inside/side_of.hpp"
#include "query/scratch.hpp"

namespace pelt {
namespace detail {
namespace {

/// A pose with its surface, as callers name them.
struct Body {
  pelt::Pose& pose;
  const pelt::Surface& surface;
};

/// Whether all components of `inner` are inside `outer`. If the surfaces do not touch, all points
/// of a component are on the same side.
bool holds(const Body& outer, const Body& inner, pelt::Scratch& scratch, QueryStats& work) {
  if (!outer.surface.is_closed()) return false;
  const PosedSurface posed = {inner.pose.detail(), inner.surface.detail()};
  for (const std::uint32_t triangle : posed.surface.components) {
    const Vec3 corner = posed.corners(triangle, work)[0];
    PointSide side;
    work += find_side(outer.pose, outer.surface, corner, scratch, side);
    if (side != PointSide::inside) return false;
  }
  return true;
}

bool touch(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch, QueryStats& work) {
  work += collide_trees(a.detail().posed_tree(), b.detail().posed_tree(), scratch.detail(), 1);
  work.cut_short = false;  // one contact suffices
  return !scratch.detail().found.empty();
}

}  // namespace

QueryStats find_containment(pelt::Pose& a, const pelt::Surface& surface_a, pelt::Pose& b,
                            const pelt::Surface& surface_b, pelt::Scratch& scratch,
                            Containment& containment) {
  PELT_ASSERT(&a != &b);
  PELT_ASSERT(&a.model().detail() == &surface_a.model().detail());
  PELT_ASSERT(&b.model().detail() == &surface_b.model().detail());
  const Body body_a = {a, surface_a}, body_b = {b, surface_b};
  QueryStats work;
  containment = Containment::none;
  if (touch(a, b, scratch, work)) return work;
  if (holds(body_b, body_a, scratch, work)) {
    containment = Containment::a_in_b;
  } else if (holds(body_a, body_b, scratch, work)) {
    containment = Containment::b_in_a;
  }
  return work;
}

}  // namespace detail

Containment containment(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                        Scratch& scratch) {
  Containment result;
  detail::find_containment(a, surface_a, b, surface_b, scratch, result);
  return result;
}

}  // namespace pelt
