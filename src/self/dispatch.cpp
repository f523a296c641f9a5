/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "self/self_tree.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(self_collide_tree)

inline namespace PELT_INSTRUCTION_SET {

SelfStats self_collide_tree(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track,
                            Scratch& scratch, std::uint32_t max_contacts) {
  return PELT_CHOOSE(self_collide_tree)(posed, filter, track, scratch, max_contacts);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
