/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "farthest/farthest_search.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(find_farthest)

inline namespace PELT_INSTRUCTION_SET {

QueryStats find_farthest(const PosedTree& posed, const Vec3& direction, FarthestVertex& farthest) {
  return PELT_CHOOSE(find_farthest)(posed, direction, farthest);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
