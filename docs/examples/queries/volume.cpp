#include <pelt/inside.hpp>

// The share of `a` that is inside `b`.
double share_inside(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch) {
  pelt::Volume whole, common;
  pelt::volume(a, whole);
  pelt::intersection_volume(a, b, scratch, common);
  return common.value / whole.value;
}
