/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "motion/first_contact_trees.hpp"
#include "motion/moving_trees.hpp"
#include "motion/self_moving_tree.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(collide_moving_trees)
PELT_DECLARE_VERSIONS(first_contact_of_trees)
PELT_DECLARE_VERSIONS(self_collide_moving_tree)

inline namespace PELT_INSTRUCTION_SET {

MovingStats collide_moving_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                 const MovingOptions& options) {
  return PELT_CHOOSE(collide_moving_trees)(a, b, scratch, options);
}

MovingStats first_contact_of_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                   std::optional<MovingContact>& first) {
  return PELT_CHOOSE(first_contact_of_trees)(a, b, scratch, first);
}

SelfMovingStats self_collide_moving_tree(const MovingTree& moving, const SelfFilter& filter,
                                         Scratch& scratch, const MovingOptions& options) {
  return PELT_CHOOSE(self_collide_moving_tree)(moving, filter, scratch, options);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
