#pragma once

/// Contacts of poses whose nodes are all open (eager), as in methods without refitting on demand.
/// Cost: the functions compute no bound.

#include <pelt/motion.hpp>

#include "pose/eager_pose.hpp"
#include "query/scratch.hpp"

#include <optional>
#include <vector>

namespace pelt::detail {

/// Appends the contacts of two poses, ascending; see pelt::collide. Precondition: all nodes are
/// open in both.
QueryStats collide(EagerPose& a, EagerPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const Limits& limits);

/// A step between two poses of one model. Precondition of queries: all nodes are open in both.
struct EagerMotion {
  EagerPose &from, &to;
};

/// Appends the contacts of two steps, ascending; see pelt::collide.
MovingStats collide(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options);

/// See pelt::first_contact.
MovingStats first_contact(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                          std::optional<MovingContact>& first);

}  // namespace pelt::detail
