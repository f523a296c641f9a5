/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "search/search_steps.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(start_search)
PELT_DECLARE_VERSIONS(advance_search)

inline namespace PELT_INSTRUCTION_SET {

QueryStats start_search(const PosedTree& a, const PosedTree& b, SearchState& state) {
  return PELT_CHOOSE(start_search)(a, b, state);
}

QueryStats advance_search(const PosedTree& a, const PosedTree& b, SearchState& state) {
  return PELT_CHOOSE(advance_search)(a, b, state);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
