/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "farthest/farthest_search.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(find_farthest)

inline namespace PELT_TARGET {

QueryStats find_farthest(const PosedTree& posed, const Vec3& direction, FarthestVertex& farthest) {
  return PELT_CHOOSE(find_farthest)(posed, direction, farthest);
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
