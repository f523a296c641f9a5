/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "distance/distance_search.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(closest_triangles)
PELT_DECLARE_VERSIONS(triangles_within)
PELT_DECLARE_VERSIONS(closest_to_point)

inline namespace PELT_INSTRUCTION_SET {

QueryStats closest_triangles(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                             const SearchLimits& limits, TriangleGap& closest) {
  return PELT_CHOOSE(closest_triangles)(a, b, scratch, limits, closest);
}

QueryStats triangles_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                            double tolerance, std::uint32_t max_pairs) {
  return PELT_CHOOSE(triangles_within)(a, b, scratch, tolerance, max_pairs);
}

QueryStats closest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& closest) {
  return PELT_CHOOSE(closest_to_point)(posed, point, scratch, max_distance, closest);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
