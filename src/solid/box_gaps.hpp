#pragma once

/// Lower bounds of the squared distances of boxes from a region, eight at a time, from the bounds
/// of place_boxes.hpp. Roots and quotients have a relative error below 2^-20, which is subtracted.
/// Underflow amounts to less than 2^-50, which is also subtracted. A NaN bound becomes 0, because
/// `max` of NaN and a number returns its second argument. Bounds that overflow become FLT_MAX,
/// which `Reach` never exceeds.

#include "solid/place_boxes.hpp"

#include <cfloat>
#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

inline Float8 squared_gap_of(const Float8& distance) {
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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
