#include "pose/pose.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"
#include "pose/refit_given.hpp"

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

Result<void> Pose::set_morph_weights(std::span<const float> weights) {
  Result<void> taken = pose_->palette.set_morph_weights(weights);
  if (taken) pose_->close_all();
  return taken;
}

Result<void> Pose::set_vertices(std::span<const Vec3> vertices) {
  return pose_->set_vertices(vertices);
}

void Pose::reserve() { pose_->reserve(); }

void posed_vertices(const Pose& pose, std::span<Vec3> out) {
  const detail::Pose& data = pose.detail();
  const detail::Tree& tree = data.model.detail().tree;
  PELT_ASSERT(out.size() == tree.vertex_count());
  if (!data.given) return pose_vertices(tree, data.palette, out);
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = data.given.vertex(tree.vertex_places[v]);
}

}  // namespace pelt
