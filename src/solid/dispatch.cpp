/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "solid/region_descent.hpp"
#include "solid/solid_distance.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(closest_to_solid)
PELT_DECLARE_VERSIONS(descend_in_faces)
PELT_DECLARE_VERSIONS(descend_in_capsule)
PELT_DECLARE_VERSIONS(descend_moving_in_faces)
PELT_DECLARE_VERSIONS(descend_moving_in_capsule)

inline namespace PELT_INSTRUCTION_SET {

QueryStats closest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& closest) {
  return PELT_CHOOSE(closest_to_solid)(posed, solid, scratch, max_distance, closest);
}

RegionAnswer descend_in_faces(const PosedTree& posed, const FacesRegion& region, Scratch& scratch,
                              RegionGoal goal) {
  return PELT_CHOOSE(descend_in_faces)(posed, region, scratch, goal);
}

RegionAnswer descend_in_capsule(const PosedTree& posed, const CapsuleRegion& region,
                                Scratch& scratch, RegionGoal goal) {
  return PELT_CHOOSE(descend_in_capsule)(posed, region, scratch, goal);
}

MovingStats descend_moving_in_faces(const MovingTree& moving, const FacesRegion& region,
                                    Scratch& scratch, const MovingOptions& options) {
  return PELT_CHOOSE(descend_moving_in_faces)(moving, region, scratch, options);
}

MovingStats descend_moving_in_capsule(const MovingTree& moving, const CapsuleRegion& region,
                                      Scratch& scratch, const MovingOptions& options) {
  return PELT_CHOOSE(descend_moving_in_capsule)(moving, region, scratch, options);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
