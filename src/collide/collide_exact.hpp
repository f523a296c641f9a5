#pragma once

#include "pose/exact_pose.hpp"
#include "query/scratch.hpp"

#include <vector>

namespace pelt::detail {

/// Appends the contacts of two poses, ascending; see pelt::collide. Precondition: all nodes are
/// open in both.
QueryStats collide(ExactPose& a, ExactPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const CollideOptions& options);

}  // namespace pelt::detail
