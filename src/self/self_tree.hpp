#pragma once

/// The door of this room: the contacts of a tree with itself. Other rooms also include
/// self_filter.hpp (what is left out), fans.hpp (the triangles around a vertex), near_joints.hpp
/// and neighbours.hpp (two triangles that share corners).

#include <pelt/self.hpp>

#include "base/instruction_set.hpp"
#include "motion/moving_tree.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "self/self_track.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `max_contacts` pairs of intersecting triangles of one pose that the filter does
/// not leave out to `scratch.found`, in no particular order.
///
/// `track`: of this filter, or null. Skips what cannot have changed since the track's last frame.
SelfStats self_collide_tree(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                            Scratch& scratch, std::uint32_t max_contacts);

/// Writes at most `options.max_contacts` pairs of triangles of one character that intersect at some
/// time of a step, and that the filter does not leave out, to `scratch.moving`, in no particular
/// order.
SelfMovingStats self_collide_moving_tree(const MovingTree& moving, const SelfFilter& filter,
                                         Scratch& scratch, const MovingOptions& options);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
