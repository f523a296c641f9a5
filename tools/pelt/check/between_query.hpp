#pragma once

/// `pelt check --between`: which triangles touch in the steps between the frames of a scene.

#include <pelt/crowd.hpp>
#include <pelt/motion.hpp>

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/palettes.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/self_filters.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>
#include <tuple>
#include <vector>

namespace pelt::tools::check {

/// Which colliders a step tests against each other.
struct BetweenTests {
  bool pairs = true;  ///< colliders against each other

  /// Also tests each collider against itself, and applies the filters to contacts of the parts of
  /// one instance, unless null.
  const scene::SelfFilters* self = nullptr;
};

/// When two triangles first touch in a step, and which of their parts meet.
struct FirstTouch {
  double seconds = 0;  ///< time of the scene, as of its frames
  double share = 0;    ///< of the step that has passed, 0 to 1
  Feature a, b;
};

/// The contacts of a step from one checked frame to the next.
struct StepContacts {
  std::uint32_t from = 0, to = 0;  ///< frames
  std::uint64_t contacts = 0;      ///< pairs of triangles that touch at any time of the step

  /// Those that touch between the frames and in neither frame, with triangle numbers of the assets.
  scene::FrameContacts between;
  std::vector<FirstTouch> firsts;  ///< of each contact of `between`

  /// Index of the contact of `between` that touches first; of equal times the first contact.
  /// Precondition: there are contacts between the frames.
  std::size_t earliest() const;
};

class BetweenQuery {
 public:
  /// `substeps`: number of straight pieces of each step, at least 1. Contacts that `ignored`
  /// matches are left out. All arguments must outlive the query.
  BetweenQuery(const scene::StagedScene& staged, std::uint32_t substeps,
               const scenes::IgnoredPairs& ignored, const BetweenTests& tests);

  /// Queries the step that leads from the frame of the call before to `frame`. `found` has the
  /// counted contacts of `frame`. Error messages name the instance.
  Result<void> ask(std::uint32_t frame, const scene::Palettes& palettes,
                   const scene::FrameContacts& found);

  /// The step of the latest call; null if it was the first of all or the first of a take.
  const StepContacts* step() const { return is_in_step_ ? &step_ : nullptr; }

  const QueryStats& work() const { return work_; }
  const std::vector<double>& step_seconds() const { return step_seconds_; }  ///< without sampling

 private:
  /// A pair of triangles that touches within a piece and not at its start.
  struct Found {
    std::uint32_t a = 0, b = 0;
    Contact contact;
    FirstTouch first;

    auto key() const { return std::tie(a, b, contact); }
  };

  Result<void> set_palettes(const scene::Palettes& palettes);
  Result<void> ask_pieces(std::uint32_t frame, const scene::Palettes& palettes);
  void ask_piece(std::uint32_t piece);
  CrowdOptions tests() const;
  void filter_parts();
  void sort_out(const scene::FrameContacts& at_end);

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
  std::vector<Found> found_;
  std::optional<std::uint32_t> frame_;  // of the latest call
  scene::FrameContacts at_start_;       // counted contacts of that frame
  bool is_in_step_ = false;
  StepContacts step_;
  QueryStats work_;
  double seconds_ = 0;  // of the current step
  std::vector<double> step_seconds_;
};

}  // namespace pelt::tools::check
