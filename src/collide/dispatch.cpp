/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "collide/collide_trees.hpp"
#include "collide/first_contact_search.hpp"
#include "collide/search.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(collide_trees)
PELT_DECLARE_VERSIONS(collide_trees_within)
PELT_DECLARE_VERSIONS(lowest_contact)
PELT_DECLARE_VERSIONS(collide_moving_trees)
PELT_DECLARE_VERSIONS(first_contact_of_trees)
PELT_DECLARE_VERSIONS(start_search)
PELT_DECLARE_VERSIONS(advance_search)
PELT_DECLARE_VERSIONS(start_first_contact)
PELT_DECLARE_VERSIONS(advance_first_contact)

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

MovingStats collide_moving_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                 const MovingOptions& options) {
  return PELT_CHOOSE(collide_moving_trees)(a, b, scratch, options);
}

MovingStats first_contact_of_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                   std::optional<MovingContact>& first) {
  return PELT_CHOOSE(first_contact_of_trees)(a, b, scratch, first);
}

QueryStats start_search(const PosedTree& a, const PosedTree& b, SearchState& state) {
  return PELT_CHOOSE(start_search)(a, b, state);
}

QueryStats advance_search(const PosedTree& a, const PosedTree& b, SearchState& state) {
  return PELT_CHOOSE(advance_search)(a, b, state);
}

MovingStats start_first_contact(const MovingTree& a, const MovingTree& b,
                                FirstContactState& state) {
  return PELT_CHOOSE(start_first_contact)(a, b, state);
}

MovingStats advance_first_contact(const MovingTree& a, const MovingTree& b,
                                  FirstContactState& state) {
  return PELT_CHOOSE(advance_first_contact)(a, b, state);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
