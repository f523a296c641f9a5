#pragma once

/// Conservative float bounds of a distance. Anything beyond these bounds is certainly farther away
/// than the distance.
///
/// Rounding. With e = 2^-24, gaps of boxes take one rounding, their squares three, sums two more
/// and underflow at most 2^-148: within (1 + 8 e) and 2^-148 of what boxes of the real vertices
/// have. The scalar distance may be kDistanceError times the largest difference of two coordinates
/// below the real one. Nothing overflows: gaps are at most those of posed vertices, below 2^62.

#include "base/instruction_set.hpp"
#include "geometry/triangle_distance.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns an upper bound of the difference of any two coordinates within two boxes.
inline double common_extent(const float* low_a, const float* high_a, const float* low_b,
                            const float* high_b) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = low_a[axis] < low_b[axis] ? low_a[axis] : low_b[axis];
    const double high = high_a[axis] > high_b[axis] ? high_a[axis] : high_b[axis];
    most = high - low > most ? high - low : most;
  }
  return most;
}

class Reach {
 public:
  /// `extent`: upper bound of the difference of any two coordinates in the query.
  explicit Reach(double extent) : slack_(extent * kDistanceError) {}

  void set(double distance) {
    const double beyond = (distance + slack_) * (1 + 0x1p-20) + 0x1p-120;
    gap_ = static_cast<float>(beyond < FLT_MAX ? beyond : FLT_MAX);
    const double squared = beyond * beyond + 0x1p-120;
    squared_gap_ = static_cast<float>(squared < FLT_MAX ? squared : FLT_MAX);
  }

  /// Lower bound of the distance of things whose boxes have this squared gap.
  double least_distance(float squared_gap) const {
    const double gap = std::sqrt(std::max(double{squared_gap} - 0x1p-120, 0.0)) - 0x1p-120;
    return std::max(gap / (1 + 0x1p-20) - slack_, 0.0);
  }

  /// For gaps of points along a direction.
  float gap() const { return gap_; }
  /// For squared gaps of boxes.
  float squared_gap() const { return squared_gap_; }

 private:
  double slack_;
  float gap_ = FLT_MAX, squared_gap_ = FLT_MAX;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
