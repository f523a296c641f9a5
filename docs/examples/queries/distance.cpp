#include <pelt/distance.hpp>

// Called every frame: the previous answer is a hint for the next search.
double gap(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch, pelt::Distance& closest) {
  const pelt::Distance last = closest;
  pelt::DistanceOptions options;
  if (last) options.hint = &last;
  pelt::distance(a, b, scratch, closest, options);
  return closest.distance;  // closest.a and closest.b say where
}

// Where a hand that reaches for `target` touches the surface.
pelt::Vec3 closest_position(pelt::Pose& pose, const pelt::Vec3& target, pelt::Scratch& scratch) {
  pelt::ClosestPoint closest;
  pelt::closest_point(pose, target, scratch, closest);
  return closest.point.position;
}
