/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "field/field_collide.hpp"
#include "field/field_distance.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(collide_field)
PELT_DECLARE_TARGETS(nearest_field_triangle)

inline namespace PELT_TARGET {

QueryStats collide_field(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return PELT_CHOOSE(collide_field)(posed, field, scratch, max_contacts);
}

QueryStats nearest_field_triangle(const PosedTree& posed, const HeightField& field,
                                  Scratch& scratch, const SearchLimits& limits,
                                  TriangleGap& nearest) {
  return PELT_CHOOSE(nearest_field_triangle)(posed, field, scratch, limits, nearest);
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
