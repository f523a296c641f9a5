#include <pelt/pose.hpp>

// An engine that stores dual quaternions passes its own floats; joint matrices must be rigid.
bool pose_rigid_joints(const pelt::SkinnedMeshView& mesh, std::span<const float> dual_quaternions) {
  const auto model = pelt::build_model(mesh, {.skinning = pelt::Skinning::dual_quaternion});
  if (!model) return false;
  pelt::Pose pose(*model);
  return static_cast<bool>(pose.set_dual_quaternions(dual_quaternions));
}
