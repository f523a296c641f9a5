#include "pose/pose.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"
#include "pose/pose_boxes.hpp"
#include "skin/skin.hpp"

#include <utility>

namespace pelt {
namespace detail {

Result<void> Pose::set_vertices(std::span<const Vec3> vertices) {
  const Tree& tree = model.detail().tree;
  if (Problem found = check_vertices(tree, vertices); !found.empty())
    return invalid_argument(std::move(found));
  close_all();
  given = refit_given(tree, vertices, arena);
  return {};
}

Problem check_offsets(const Tree& tree, std::span<const Vec3> offsets) {
  if (offsets.empty()) return {};
  if (tree.offset_caps.empty())
    return problem("the model has no caps for offsets: set SkinnedMeshView::offset_caps");
  if (offsets.size() == tree.vertex_count()) return {};
  return problem("offsets has %zu elements, expected none or one for each of the %u vertices",
                 offsets.size(), tree.vertex_count());
}

Result<void> Pose::set_offsets(std::span<const Vec3> offsets) {
  if (Problem found = check_offsets(model.detail().tree, offsets); !found.empty())
    return invalid_argument(std::move(found));
  palette.set_offsets(offsets);
  close_all();
  return {};
}

void Pose::reserve() {
  const Tree& tree = model.detail().tree;
  const Arena old = std::exchange(arena, Arena());
  const GivenVertices kept = given;
  close_all();
  arena.reserve(bytes_to_open(tree));
  if (kept) given = copy_given(tree, kept, arena);
}

}  // namespace detail

Pose::Pose(SkinnedModel model) : pose_(std::make_unique<detail::Pose>(std::move(model))) {}
Pose::Pose(Pose&&) noexcept = default;
Pose& Pose::operator=(Pose&&) noexcept = default;
Pose::~Pose() = default;

const SkinnedModel& Pose::model() const { return pose_->model; }

Result<void> Pose::set_palette(const JointMatrices& palette) {
  Result<void> taken = pose_->palette.set(palette);
  if (taken) pose_->close_all();
  return taken;
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

Result<void> Pose::set_vertices(std::span<const Vec3> vertices) {
  return pose_->set_vertices(vertices);
}

Result<void> Pose::set_offsets(std::span<const Vec3> offsets) {
  return pose_->set_offsets(offsets);
}

void Pose::reserve() { pose_->reserve(); }

void posed_vertices(const Pose& pose, std::span<Vec3> out) {
  const detail::Pose& data = pose.detail();
  const detail::Tree& tree = data.model.detail().tree;
  PELT_ASSERT(out.size() == tree.vertex_count());
  if (!data.given) return pose_vertices(tree, data.palette, out);
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = data.given.vertex(tree.vertex_places[v]);
}

std::uint32_t check_offsets(const Pose& pose) {
  const detail::Tree& tree = pose.model().detail().tree;
  const std::span<const Vec3> offsets = pose.detail().palette.offsets();
  std::uint32_t clamped = 0;
  for (std::size_t v = 0; v < offsets.size(); ++v)
    clamped += detail::is_clamped(offsets[v], tree.offset_caps[tree.vertex_places[v]]);
  return clamped;
}

}  // namespace pelt
