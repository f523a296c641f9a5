/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "solid/solid_search.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(nearest_to_solid)

inline namespace PELT_TARGET {

QueryStats nearest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& nearest) {
  return PELT_CHOOSE(nearest_to_solid)(posed, solid, scratch, max_distance, nearest);
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
