#pragma once

#include <pelt/mesh.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pelt::peers {

/// A model of CGAL's concept BoxIntersectionBox_d.
struct CgalBox {
  using NT = float;
  using ID = std::uint32_t;

  static int dimension() { return 3; }
  float min_coord(int axis) const { return low[axis]; }
  float max_coord(int axis) const { return high[axis]; }
  /// Distinct in both sets together.
  ID id() const { return triangle | body << 31; }

  void include(const Vec3& p) {
    const float at[3] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], at[axis]);
      high[axis] = std::max(high[axis], at[axis]);
    }
  }
  void include(const CgalBox& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
  bool meets(const CgalBox& other) const {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis)
      all = all && low[axis] <= other.high[axis] && other.low[axis] <= high[axis];
    return all;
  }

  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  float low[3] = {kInfinity, kInfinity, kInfinity};
  float high[3] = {-kInfinity, -kInfinity, -kInfinity};
  std::uint32_t triangle = 0;
  std::uint32_t body = 0;  ///< 0 or 1, within a query
};

}  // namespace pelt::peers
