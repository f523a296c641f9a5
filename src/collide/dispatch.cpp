/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "collide/collide_trees.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(collide_trees)

inline namespace PELT_INSTRUCTION_SET {

QueryStats collide_trees(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return PELT_CHOOSE(collide_trees)(a, b, scratch, max_contacts);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
