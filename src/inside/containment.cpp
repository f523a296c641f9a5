#include <pelt/inside.hpp>

#include "base/assert.hpp"
#include "contact/traces.hpp"

#include <algorithm>

namespace pelt {
namespace {

/// Where surfaces do not touch, what hangs together is inside with all its points or with none.
bool holds(Pose& outer, const Surface& outer_surface, Pose& inner, const Surface& inner_surface,
           Scratch& scratch) {
  if (!outer_surface.is_closed()) return false;
  const detail::PosedSurface posed = {inner.detail(), inner_surface.detail()};
  const std::vector<std::uint32_t>& components = posed.surface.components;
  return std::all_of(components.begin(), components.end(), [&](std::uint32_t triangle) {
    const Vec3 corner = posed.corners(triangle)[0];
    return side_of(outer, outer_surface, corner, scratch) == PointSide::inside;
  });
}

}  // namespace

Containment containment(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                        Scratch& scratch) {
  PELT_ASSERT(&a.model().detail() == &surface_a.model().detail());
  PELT_ASSERT(&b.model().detail() == &surface_b.model().detail());
  if (intersects(a, b, scratch)) return Containment::none;
  if (holds(b, surface_b, a, surface_a, scratch)) return Containment::a_in_b;
  return holds(a, surface_a, b, surface_b, scratch) ? Containment::b_in_a : Containment::none;
}

}  // namespace pelt
