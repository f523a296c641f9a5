#pragma once

#include "base/instruction_set.hpp"
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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
