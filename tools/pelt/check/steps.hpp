#pragma once

/// Contacts in the steps from one checked frame to the next, and their sums over all steps.

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/check/touches.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"

#include <vector>

namespace pelt::tools::check {

struct StepContacts {
  std::uint32_t from = 0, to = 0;  ///< frames
  std::uint64_t contacts = 0;      ///< pairs of triangles that touch at any time of the step

  /// Pairs of triangles that touch between the frames and in neither frame, with the numbers of the
  /// assets.
  scene::FrameContacts between;
  std::vector<FirstTouch> firsts;  ///< of each contact of `between`

  /// Index of the contact of `between` that touches first; of equal times the first contact.
  /// Precondition: there are contacts between the frames.
  std::size_t earliest() const;
};

/// A step in which triangles touch between the frames and in neither frame.
struct StepBetween {
  std::uint32_t from = 0, to = 0;  ///< frames
  std::uint64_t contacts = 0;      ///< between the frames
  FoundInStep earliest;            ///< the contact that touches first
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
