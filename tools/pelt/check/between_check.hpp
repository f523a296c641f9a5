#pragma once

/// Results of `pelt check --between` over all steps.

#include "tools/pelt/check/between_query.hpp"
#include "tools/pelt/check/chord_deviation.hpp"
#include "tools/pelt/check/touch_tally.hpp"
#include "tools/pelt/scene/contact_hash.hpp"

#include <vector>

namespace pelt::tools::check {

/// A step in which triangles touch between the frames and in neither frame.
struct StepBetween {
  /// The contact of the step that touches first.
  struct Earliest {
    std::uint32_t a = 0, b = 0;  ///< colliders
    Contact contact;             ///< triangle numbers of the assets
    FirstTouch first;
  };

  std::uint32_t from = 0, to = 0;  ///< frames
  std::uint64_t contacts = 0;      ///< between the frames
  Earliest earliest;
};

struct BetweenReport {
  /// The deviation of one step if it is divided into this number of straight pieces.
  struct Fall {
    std::uint32_t substeps = 1;
    double distance = 0;
  };

  std::uint32_t substeps = 1;      ///< straight pieces of each step
  std::uint64_t steps = 0;         ///< steps queried
  std::uint64_t contacts = 0;      ///< between frames, counted in each step
  std::vector<StepBetween> found;  ///< in order of steps
  std::vector<Touch> touches;      ///< of contacts between frames; `frames` counts steps
  std::vector<TouchTally::Row> joints, parts;  ///< of contacts between frames, likewise
  Deviation deviation;                         ///< the largest of all steps
  std::vector<Fall> falls;                     ///< of its step, for more and more substeps
  std::uint64_t hash = 0;                      ///< of contacts between frames
  QueryStats work;
  std::vector<double> step_seconds;  ///< setting palettes and querying, without sampling
};

class BetweenCheck {
 public:
  /// `tally` must be empty. See BetweenQuery.
  BetweenCheck(const scene::StagedScene& staged, std::uint32_t substeps,
               const scenes::IgnoredPairs& ignored, const BetweenTests& tests, TouchTally tally);

  /// See BetweenQuery::ask.
  Result<void> ask(std::uint32_t frame, const scene::Palettes& palettes,
                   const scene::FrameContacts& found);

  /// The step of the latest call; null if no triangles touch between its frames only.
  const StepContacts* step() const;

  /// Measures how the largest deviation falls. Precondition: all frames were asked.
  Result<BetweenReport> report();

 private:
  void add(const StepContacts& step);

  BetweenQuery query_;
  ChordDeviation deviation_;
  TouchTally tally_;
  scene::ContactHash hash_;
  BetweenReport report_;
};

}  // namespace pelt::tools::check
