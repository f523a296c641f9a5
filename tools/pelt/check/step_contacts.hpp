#pragma once

/// The contacts of a step from one checked frame to the next.

#include "tools/pelt/check/between_query.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <vector>

namespace pelt::tools::check {

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

/// Returns the contacts of a step. `at_start` and `at_end` are the counted contacts of its frames.
/// What touches at the start of a piece has touched in the piece before or at the start of the
/// step, so `step` and `at_start` have all contacts. O(n log n) in contacts.
StepContacts contacts_of_step(const StepAnswer& step, const scene::FrameContacts& at_start,
                              const scene::FrameContacts& at_end);

}  // namespace pelt::tools::check
