#include "pose/pose.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"

#include <utility>

namespace pelt {
Pose::Pose(SkinnedModel model) : pose_(std::make_unique<detail::Pose>(std::move(model))) {}
Pose::Pose(Pose&&) noexcept = default;
Pose& Pose::operator=(Pose&&) noexcept = default;
Pose::~Pose() = default;

const SkinnedModel& Pose::model() const { return pose_->model; }

Result<void> Pose::set_palette(std::span<const Matrix4> palette) {
  return set_palette(detail::floats_of(palette));
}

Result<void> Pose::set_palette(std::span<const float> palette) {
  return pose_->set_palette(palette);
}

Result<void> Pose::set_palette(std::span<const Matrix3x4> palette) {
  return pose_->set_palette(palette);
}

Result<void> Pose::set_palette(std::span<const double> palette) {
  return pose_->set_palette(palette);
}

Result<void> Pose::set_dual_quaternions(std::span<const float> dual_quaternions) {
  Result<void> taken = pose_->palette.set_dual_quaternions(dual_quaternions);
  if (taken) pose_->close_all();
  return taken;
}

Result<void> Pose::set_morph_weights(std::span<const float> weights) {
  Result<void> taken = pose_->palette.set_morph_weights(weights);
  if (taken) pose_->close_all();
  return taken;
}

void Pose::reserve() { pose_->reserve(); }

void posed_vertices(const Pose& pose, std::span<Vec3> out) {
  const detail::Pose& data = pose.detail();
  const detail::Tree& tree = data.model.detail().tree;
  PELT_ASSERT(out.size() == tree.vertex_count());
  detail::pose_vertices(tree, data.palette, out);
}

}  // namespace pelt
