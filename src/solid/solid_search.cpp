#include "solid/solid_distance.hpp"

#include "distance/triangle_search.hpp"
#include "solid/place_boxes.hpp"

#include <cfloat>
#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

// Lower bounds of the squared distances of boxes from a region, eight at a time, from the bounds of
// place_boxes.hpp. Roots and quotients have a relative error below 2^-20, which is subtracted.
// Underflow amounts to less than 2^-50, which is also subtracted. A NaN bound becomes 0, because
// `max` of NaN and a number returns its second argument. Bounds that overflow become FLT_MAX, which
// `Reach` never exceeds.

Float8 squared_gap_of(const Float8& distance) {
  const Float8 gap = max(distance * Float8(1 - 0x1p-18f) - Float8(0x1p-50f), Float8(0.0f));
  return min(gap * gap, Float8(FLT_MAX));
}

class FacesGaps {
 public:
  explicit FacesGaps(const FacesRegion& region) : region_(region) {
    for (std::uint32_t i = 0; i < region.count; ++i) {
      const float* n = region.scaled[i].normal;
      per_length_[i] = 1 / std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
  }

  /// Largest distance of a box outside of a face.
  Float8 operator()(const Boxes8& boxes) const {
    const Reaches8 reaches(boxes);
    Float8 farthest(0.0f);
    for (std::uint32_t i = 0; i < region_.count; ++i) {
      const OutsideFace outside = outside_of(region_.scaled[i], boxes, reaches);
      farthest = max((outside.closest - outside.error) * Float8(per_length_[i]), farthest);
    }
    return squared_gap_of(farthest);
  }

 private:
  const FacesRegion& region_;
  float per_length_[ConvexPolyhedron::kMaxFaces];
};

class CapsuleGaps {
 public:
  explicit CapsuleGaps(const CapsuleRegion& region) : capsule_(region.capsule) {}

  Float8 operator()(const Boxes8& boxes) const {
    const FromSegment from = from_segment(capsule_, boxes);
    const Float8 to_segment = from.clear / sqrt(from.squared_direction);
    return squared_gap_of(to_segment * Float8(1 - 0x1p-18f) - Float8(capsule_.radius));
  }

 private:
  const Capsule& capsule_;
};

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
