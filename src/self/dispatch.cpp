/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "self/self_tree.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(self_collide_tree)
PELT_DECLARE_VERSIONS(self_collide_moving_tree)

inline namespace PELT_INSTRUCTION_SET {

SelfStats self_collide_tree(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                            Scratch& scratch, std::uint32_t max_contacts) {
  return PELT_CHOOSE(self_collide_tree)(posed, filter, track, scratch, max_contacts);
}

SelfMovingStats self_collide_moving_tree(const MovingTree& moving, const SelfFilter& filter,
                                         Scratch& scratch, const MovingOptions& options) {
  return PELT_CHOOSE(self_collide_moving_tree)(moving, filter, scratch, options);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
