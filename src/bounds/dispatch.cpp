/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "bounds/bounds_search.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(bounding_box)
PELT_DECLARE_VERSIONS(bounding_radius)
PELT_DECLARE_VERSIONS(bound_of_set)
PELT_DECLARE_VERSIONS(box_given)
PELT_DECLARE_VERSIONS(box_places)
PELT_DECLARE_VERSIONS(find_farthest)

inline namespace PELT_INSTRUCTION_SET {

BoxFound bounding_box(const PosedTree& posed, std::uint32_t levels) {
  return PELT_CHOOSE(bounding_box)(posed, levels);
}

float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre) {
  return PELT_CHOOSE(bounding_radius)(bounds, palette, centre);
}

BoxFound bound_of_set(const NodeBounds& bounds, std::uint32_t set, const Palette& palette) {
  return PELT_CHOOSE(bound_of_set)(bounds, set, palette);
}

BoxFound box_given(const GivenVertices& given, std::span<const std::uint32_t> places) {
  return PELT_CHOOSE(box_given)(given, places);
}

BoxFound box_places(const Tree& tree, const Palette& palette,
                    std::span<const std::uint32_t> places) {
  return PELT_CHOOSE(box_places)(tree, palette, places);
}

QueryStats find_farthest(const PosedTree& posed, const Vec3& direction, FarthestVertex& farthest) {
  return PELT_CHOOSE(find_farthest)(posed, direction, farthest);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
