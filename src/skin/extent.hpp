#pragma once

#include <pelt/math.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pelt::detail {

/// Returns the sum over the axes of the largest absolute coordinate of any point, rounded up.
inline float extent_of(std::span<const Vec3> points) {
  Vec3 largest;
  for (const Vec3& p : points)
    largest = {std::max(largest.x, std::fabs(p.x)), std::max(largest.y, std::fabs(p.y)),
               std::max(largest.z, std::fabs(p.z))};
  const double sum = double{largest.x} + double{largest.y} + double{largest.z};
  return std::nextafter(static_cast<float>(sum), std::numeric_limits<float>::infinity());
}

}  // namespace pelt::detail
