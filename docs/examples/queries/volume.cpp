#include <pelt/inside.hpp>

// The share of `a` that is inside `b`.
double share_inside(pelt::Pose& a, const pelt::Surface& surface_a, pelt::Pose& b,
                    const pelt::Surface& surface_b, pelt::Scratch& scratch) {
  pelt::Volume whole, common;
  pelt::volume(a, surface_a, whole);
  pelt::intersection_volume(a, surface_a, b, surface_b, scratch, common);
  return common.value / whole.value;
}
