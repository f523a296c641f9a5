#pragma once

#include <pelt/motion.hpp>

#include "pose/exact_pose.hpp"
#include "query/scratch.hpp"

#include <optional>
#include <vector>

namespace pelt::detail {

/// A step between two poses of one model. Precondition of queries: all nodes are open in both.
struct ExactMotion {
  ExactPose &from, &to;
};

/// Appends the contacts of two steps, ascending; see pelt::collide_moving.
MovingStats collide_moving(const ExactMotion& a, const ExactMotion& b, Scratch& scratch,
                           std::vector<MovingContact>& contacts, const MovingOptions& options);

/// See pelt::first_contact.
MovingStats first_contact(const ExactMotion& a, const ExactMotion& b, Scratch& scratch,
                          std::optional<MovingContact>& first);

}  // namespace pelt::detail
