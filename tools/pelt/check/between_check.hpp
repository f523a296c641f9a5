#pragma once

/// Results of `pelt check --between` over all steps.

#include "tools/pelt/check/chord_deviation.hpp"
#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/check/step_contacts.hpp"
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
  /// `staged` must outlive the object. `tally` must be empty.
  BetweenCheck(const scene::StagedScene& staged, std::uint32_t substeps, TouchTally tally);

  /// Adds the step that ends with a frame, if it has one. Call once for each frame, in order.
  /// Returns the contacts of the step, valid until the next call; null if no triangles touch
  /// between its frames only.
  const StepContacts* add(const FrameAnswer& answer);

  /// Measures how the largest deviation falls. Precondition: all frames were added.
  Result<BetweenReport> report();

 private:
  void add_contacts();

  scene::StagedScene staged_;
  TouchTally tally_;
  scene::ContactHash hash_;
  scene::FrameContacts at_start_;  // counted contacts of the latest frame
  StepContacts step_;
  BetweenReport report_;
};

}  // namespace pelt::tools::check
