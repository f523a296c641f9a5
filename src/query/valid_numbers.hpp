#pragma once

/// Checks of the numbers that callers pass to queries, for `require`.

#include <pelt/ray.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace pelt::detail {

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

inline bool is_valid(const Ray& ray) {
  return is_finite(ray.origin) && is_finite(ray.direction) && !std::isnan(ray.t_min) &&
         !std::isnan(ray.t_max);
}

inline bool are_valid(std::span<const Ray> rays) {
  return std::all_of(rays.begin(), rays.end(), is_valid);
}

}  // namespace pelt::detail
