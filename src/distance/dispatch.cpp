/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "distance/pair_search.hpp"
#include "distance/point_search.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(nearest_triangles)
PELT_DECLARE_TARGETS(triangles_within)
PELT_DECLARE_TARGETS(nearest_to_point)

inline namespace PELT_TARGET {

QueryStats nearest_triangles(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                             const SearchLimits& limits, TriangleGap& nearest) {
  return PELT_CHOOSE(nearest_triangles)(a, b, scratch, limits, nearest);
}

QueryStats triangles_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                            double tolerance, std::uint32_t max_pairs) {
  return PELT_CHOOSE(triangles_within)(a, b, scratch, tolerance, max_pairs);
}

QueryStats nearest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& nearest) {
  return PELT_CHOOSE(nearest_to_point)(posed, point, scratch, max_distance, nearest);
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
