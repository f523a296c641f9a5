#pragma once

/// Intervals of doubles, and boxes of floats that enclose them.

#include "base/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt::detail {

/// `value` rounded up to a float.
inline float rounded_up(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return (low + high) / 2; }

  /// Largest distance of a point of the interval from `value`.
  double reach(double value) const { return std::max(high - value, value - low); }
};

struct Intervals3 {
  Interval x, y, z;

  void include(const Vec3d& p) { x.include(p.x), y.include(p.y), z.include(p.z); }
  Vec3d middle() const { return {x.middle(), y.middle(), z.middle()}; }

  /// Rounds the centre to float and the half extents up, so that the box encloses the intervals.
  void store(float* centre, float* half) const {
    const Interval* axes[] = {&x, &y, &z};
    for (int a = 0; a < 3; ++a) {
      centre[a] = static_cast<float>(axes[a]->middle());
      half[a] = rounded_up(axes[a]->reach(static_cast<double>(centre[a])));
    }
  }
};

}  // namespace pelt::detail
