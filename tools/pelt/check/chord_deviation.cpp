#include "tools/pelt/check/chord_deviation.hpp"

#include <cmath>
#include <utility>

namespace pelt::tools::check {
namespace {

/// Distance of `middle` from the middle of `begin` and `end`.
double distance_from_middle(const Vec3& begin, const Vec3& middle, const Vec3& end) {
  const auto along = [](float from, float at, float to) {
    return double{at} - (double{from} + double{to}) / 2;
  };
  const double x = along(begin.x, middle.x, end.x);
  const double y = along(begin.y, middle.y, end.y);
  const double z = along(begin.z, middle.z, end.z);
  return std::sqrt(x * x + y * y + z * z);
}

Result<void> pose_vertices(const scene::PoseInputs& inputs, Pose& pose, std::vector<Vec3>& out) {
  if (const auto posed = scene::set_pose(inputs, pose); !posed) return posed;
  out.resize(pose.model().vertex_count());
  posed_vertices(pose, out);
  return {};
}

}  // namespace

ChordDeviation::ChordDeviation(const scene::StagedScene& staged) : staged_(staged) {
  for (const scene::Collider& collider : staged.colliders) poses_.emplace_back(collider.model);
}

Result<Deviation> ChordDeviation::of_step(std::uint32_t from, std::uint32_t to,
                                          std::uint32_t substeps) {
  Deviation largest;
  largest.from = from;
  largest.to = to;
  std::uint32_t sampled = static_cast<std::uint32_t>(staged_.scene.instances.size());
  for (std::uint32_t c = 0; c < poses_.size(); ++c) {
    const std::uint32_t instance = staged_.colliders[c].instance;
    if (instance != std::exchange(sampled, instance)) sample(instance, largest, substeps);
    if (const auto measured = measure(c, largest); !measured)
      return scene::in_instance(instance, measured.error());
  }
  return largest;
}

void ChordDeviation::sample(std::uint32_t instance, const Deviation& step, std::uint32_t substeps) {
  halves_.resize(2 * std::size_t{substeps} + 1);
  for (std::size_t half = 0; half < halves_.size(); ++half) {
    const double later = (step.to - step.from) * (static_cast<double>(half) / (2.0 * substeps));
    sample_instance(staged_.scene, instance, {step.from, later}, scratch_, halves_[half]);
  }
}

/// Updates `largest` by the vertices of a collider. Precondition: its instance is sampled.
Result<void> ChordDeviation::measure(std::uint32_t collider, Deviation& largest) {
  const auto pose = [&](std::size_t half, std::vector<Vec3>& out) {
    return pose_vertices(selection_.select(halves_[half], staged_.colliders[collider]),
                         poses_[collider], out);
  };
  if (const auto posed = pose(0, end_); !posed) return posed;
  for (std::size_t half = 2; half < halves_.size(); half += 2) {
    std::swap(begin_, end_);
    if (const auto posed = pose(half - 1, middle_); !posed) return posed;
    if (const auto posed = pose(half, end_); !posed) return posed;
    for (std::uint32_t v = 0; v < end_.size(); ++v) {
      const double distance = distance_from_middle(begin_[v], middle_[v], end_[v]);
      if (distance <= largest.distance) continue;
      largest.distance = distance;
      largest.collider = collider;
      largest.vertex = v;
    }
  }
  return {};
}

}  // namespace pelt::tools::check
