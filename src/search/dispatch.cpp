/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "search/first_contact_steps.hpp"
#include "search/search_steps.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(start_search)
PELT_DECLARE_VERSIONS(advance_search)
PELT_DECLARE_VERSIONS(start_first_contact)
PELT_DECLARE_VERSIONS(advance_first_contact)

inline namespace PELT_INSTRUCTION_SET {

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
