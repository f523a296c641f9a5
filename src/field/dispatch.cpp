/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "field/field_trees.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(collide_field)
PELT_DECLARE_VERSIONS(closest_field_triangle)
PELT_DECLARE_VERSIONS(collide_moving_field)

inline namespace PELT_INSTRUCTION_SET {

QueryStats collide_field(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return PELT_CHOOSE(collide_field)(posed, field, scratch, max_contacts);
}

QueryStats closest_field_triangle(const PosedTree& posed, const HeightField& field,
                                  Scratch& scratch, const SearchLimits& limits,
                                  TriangleGap& closest) {
  return PELT_CHOOSE(closest_field_triangle)(posed, field, scratch, limits, closest);
}

MovingStats collide_moving_field(const MovingTree& moving, const HeightField& field,
                                 Scratch& scratch, const MovingOptions& options) {
  return PELT_CHOOSE(collide_moving_field)(moving, field, scratch, options);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
