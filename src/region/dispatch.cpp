/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "region/region_descent.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(descend_in_faces)
PELT_DECLARE_TARGETS(descend_in_capsule)

inline namespace PELT_TARGET {

RegionAnswer descend_in_faces(const PosedTree& posed, const FacesRegion& region, Scratch& scratch,
                              RegionWish wish) {
  return PELT_CHOOSE(descend_in_faces)(posed, region, scratch, wish);
}

RegionAnswer descend_in_capsule(const PosedTree& posed, const CapsuleRegion& region,
                                Scratch& scratch, RegionWish wish) {
  return PELT_CHOOSE(descend_in_capsule)(posed, region, scratch, wish);
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
