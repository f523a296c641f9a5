#pragma once

/// `pelt check --between`: which triangles touch in the steps between the frames of a scene.

#include <pelt/crowd.hpp>
#include <pelt/motion.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/check/stage.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <optional>
#include <vector>

namespace pelt::tools::check {

/// How far the clips of a scene deviate from the straight lines that steps test.
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

/// Queries single steps, in any order. Answers do not depend on the order.
class StepQuery {
 public:
  /// Contacts that the stage ignores are left out. `stage` is prepared, and must outlive the query.
  /// `threads`: of each query; 0 means all cores.
  StepQuery(const Stage& stage, std::uint32_t threads);

  /// Queries the step between two frames of one take. Replaces `step`. `at_end` has the palettes of
  /// `to`. Error messages name the instance. Poses the start of the step only if the latest call
  /// did not end there.
  Result<void> ask(std::uint32_t from, std::uint32_t to, const scene::Palettes& at_end,
                   StepAnswer& step);

 private:
  Result<void> set_palettes(const scene::Palettes& palettes);
  Result<void> pose_start(std::uint32_t frame);
  Result<void> ask_pieces(const scene::Palettes& at_end, StepAnswer& step);
  void ask_piece(std::uint32_t piece, StepAnswer& step);
  void filter_parts();

  const Stage& stage_;
  std::uint32_t substeps_;
  scene::SelfTests tests_;
  std::uint32_t threads_;
  Crowd crowd_;  // of the colliders
  ChordDeviation deviation_;
  scene::PartedInstances parted_;
  scene::InputSelection selection_;
  asset::SampleScratch sample_scratch_;
  scene::Palettes palettes_;
  std::vector<CrowdMovingContact> moving_;
  std::vector<Contact> kept_;  // of `filter_parts`
  Scratch scratch_;
  std::optional<std::uint32_t> posed_;  // the frame of the poses of the crowd
};

}  // namespace pelt::tools::check
