#pragma once

/// `pelt check --between`: which triangles touch in the steps between the frames of a scene.

#include <pelt/crowd.hpp>
#include <pelt/motion.hpp>

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/check/chord_deviation.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/palettes.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/self_filters.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>
#include <vector>

namespace pelt::tools::check {

/// Which colliders a step tests against each other.
struct BetweenTests {
  bool pairs = true;  ///< colliders against each other

  /// Also tests each collider against itself, and applies the filters to contacts of the parts of
  /// one instance, unless null.
  const scene::SelfFilters* self = nullptr;

  std::uint32_t threads = 0;  ///< of each query; 0 means all cores
};

/// When two triangles first touch in a step, and which of their parts meet.
struct FirstTouch {
  double seconds = 0;  ///< time of the scene, as of its frames
  double share = 0;    ///< of the step that has passed, 0 to 1
  Feature a, b;
};

/// A pair of triangles that touches within a step and not at the start of a piece of it.
struct FoundInStep {
  std::uint32_t a = 0, b = 0;  ///< colliders
  Contact contact;             ///< triangle numbers of the assets
  FirstTouch first;
};

/// What the query of a step from one checked frame to the next finds.
struct StepAnswer {
  std::uint32_t from = 0, to = 0;  ///< frames
  std::vector<FoundInStep> found;  ///< ascending by colliders and triangles, without duplicates
  Deviation deviation;             ///< of the clips from straight lines
  QueryStats work;
  double seconds = 0;  ///< setting palettes and querying, without sampling
};

/// Queries single steps, in any order. Answers do not depend on the order.
class BetweenQuery {
 public:
  /// `substeps`: number of straight pieces of each step, at least 1. Contacts that `ignored`
  /// matches are left out. All arguments must outlive the query.
  BetweenQuery(const scene::StagedScene& staged, std::uint32_t substeps,
               const scenes::IgnoredPairs& ignored, const BetweenTests& tests);

  /// Queries the step between two frames of one take. Replaces `step`, except for its deviation.
  /// `at_end` has the palettes of `to`. Error messages name the instance. Poses the start of the
  /// step only if the latest call did not end there.
  Result<void> ask(std::uint32_t from, std::uint32_t to, const scene::Palettes& at_end,
                   StepAnswer& step);

 private:
  Result<void> set_palettes(const scene::Palettes& palettes);
  Result<void> pose_start(std::uint32_t frame);
  Result<void> ask_pieces(const scene::Palettes& at_end, StepAnswer& step);
  void ask_piece(std::uint32_t piece, StepAnswer& step);
  CrowdOptions tests() const;
  void filter_parts();

  scene::StagedScene staged_;
  std::uint32_t substeps_;
  const scenes::IgnoredPairs& ignored_;
  BetweenTests tests_;
  std::vector<const SelfFilter*> filters_of_parts_;  // of each instance; empty without such filters
  Crowd crowd_;                                      // of the colliders
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
