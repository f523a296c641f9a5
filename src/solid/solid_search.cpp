#include "solid/solid_search.hpp"

#include "distance/triangle_search.hpp"
#include "solid/box_gaps.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Search for the triangle closest to a solid; of equally near triangles, the lowest. `Gaps`
/// computes lower bounds of the squared distances of eight boxes.
template <typename Gaps>
class ClosestToSolid {
 public:
  ClosestToSolid(const PreparedSolid& solid, const Gaps& gaps, double max_distance, SolidGap& best)
      : solid_(solid), gaps_(gaps), reach_(max_distance), best_(best) {}

  double extent(const RootBox& box) const {
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = std::fabs(box.low[axis]), high = std::fabs(box.high[axis]);
      const double larger = low < high ? high : low;
      most = most < larger ? larger : most;
    }
    return 2 * (most + solid_.extent);
  }

  Float8 squared_gaps(const Boxes8& boxes) const { return gaps_(boxes); }

  bool takes(std::uint32_t triangle, const TriangleCorners& corners) {
    const SolidPoints points = closest_points(corners, solid_.solid);
    if (!is_better(points.distance, triangle)) return false;
    best_ = {triangle, corners, points};
    reach_ = points.distance;
    return true;
  }

  double reach() const { return reach_; }

 private:
  bool is_better(double distance, std::uint32_t triangle) const {
    const double best = best_.closest.distance;
    if (distance == best) return triangle < best_.triangle;
    return distance < best && distance <= reach_;
  }

  const PreparedSolid& solid_;
  const Gaps& gaps_;
  double reach_;  // initially the maximum, then the least distance so far
  SolidGap& best_;
};

}  // namespace

QueryStats closest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& closest) {
  const auto search = [&](const auto& gaps) {
    ClosestToSolid goal(solid, gaps, max_distance, closest);
    return TriangleSearch(posed, scratch, goal).run();
  };
  return solid.region.is_capsule ? search(CapsuleGaps(solid.region.capsule))
                                 : search(FacesGaps(solid.region.faces));
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
