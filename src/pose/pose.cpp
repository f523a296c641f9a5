#include "pose/pose.hpp"

#include "pose/skin.hpp"

#include <utility>

namespace pelt {

Pose::Pose(SkinnedModel model) {
  const detail::Model& data = model.detail();
  detail::Palette palette(data.mesh.joint_count, data.mesh.rest_radius);
  auto engine_pose = detail::make_engine_pose(*data.engine);
  pose_ = std::make_unique<detail::Pose>(
      detail::Pose{std::move(model), std::move(palette), std::move(engine_pose)});
}

Pose::Pose(Pose&&) noexcept = default;
Pose& Pose::operator=(Pose&&) noexcept = default;
Pose::~Pose() = default;

const SkinnedModel& Pose::model() const { return pose_->model; }

Result<void> Pose::set_palette(std::span<const Matrix4> palette) {
  return set_palette({palette.empty() ? nullptr : palette[0].m.data(), palette.size() * 16});
}

Result<void> Pose::set_palette(std::span<const float> palette) {
  Result<void> taken = pose_->palette.set(palette);
  if (taken) detail::invalidate(*pose_->engine_pose);
  return taken;
}

void posed_vertices(const Pose& pose, std::span<Vec3> out) {
  const detail::Pose& data = pose.detail();
  detail::posed_vertices(data.model.detail().mesh, data.palette, out);
}

}  // namespace pelt
