/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "collide/collide_trees.hpp"
#include "collide/lowest_contact.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(collide_trees)
PELT_DECLARE_VERSIONS(collide_trees_within)
PELT_DECLARE_VERSIONS(lowest_contact)

inline namespace PELT_INSTRUCTION_SET {

QueryStats collide_trees(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return PELT_CHOOSE(collide_trees)(a, b, scratch, max_contacts);
}

QueryStats collide_trees_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                                std::uint32_t max_contacts, std::uint64_t max_work) {
  return PELT_CHOOSE(collide_trees_within)(a, b, scratch, max_contacts, max_work);
}

QueryStats lowest_contact(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                          std::optional<Contact>& lowest) {
  return PELT_CHOOSE(lowest_contact)(a, b, scratch, lowest);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
