#include <pelt/ray.hpp>

// The joint that the surface under the mouse follows most, or -1.
int picked_joint(pelt::Pose& pose, const pelt::Vec3& eye, const pelt::Vec3& far_away) {
  pelt::RayHit hit;
  pelt::cast(pose, pelt::segment(eye, far_away), hit);
  if (!hit) return -1;
  std::vector<pelt::JointShare> joints;
  pelt::influences_at(pose.model(), hit, joints);
  return static_cast<int>(joints[0].joint);
}
