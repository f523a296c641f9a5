#pragma once

/// How far the clips of a scene deviate from the straight lines that `pelt check --between` tests.

#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <vector>

namespace pelt::tools::check {

/// The largest distance of a posed vertex, at the middle of a piece of a step, from the middle of
/// its posed positions at both ends of the piece. Both kinds of positions are those of float32
/// skinning.
struct Deviation {
  double distance = 0;
  std::uint32_t collider = 0, vertex = 0;  ///< vertex of the collider's own model
  std::uint32_t from = 0, to = 0;          ///< frames of the step
};

class ChordDeviation {
 public:
  /// `staged` must outlive the object.
  explicit ChordDeviation(const scene::StagedScene& staged);

  /// Measures all vertices of all colliders in a step of `substeps` pieces. Error messages name the
  /// instance. Cost: 2 substeps + 1 times that of sampling and skinning all instances.
  Result<Deviation> of_step(std::uint32_t from, std::uint32_t to, std::uint32_t substeps);

 private:
  void sample(std::uint32_t instance, const Deviation& step, std::uint32_t substeps);
  Result<void> measure(std::uint32_t collider, Deviation& largest);

  scene::StagedScene staged_;
  std::vector<Pose> poses_;  // of each collider
  asset::SampleScratch scratch_;
  scene::InputSelection selection_;
  std::vector<scene::Palettes> halves_;     // of one instance, at the ends of half pieces
  std::vector<Vec3> begin_, middle_, end_;  // posed vertices of a piece
};

}  // namespace pelt::tools::check
