#pragma once

#include <pelt/math.hpp>

namespace pelt::test {

/// The vertices of eight triangles: vertex k of triangle i is [k][i], four floats of which the last
/// is unused.
using RayLaneCorners = float[3][8][4];

/// One bit for each triangle.
struct RayLaneMasks {
  unsigned missed, met_from_front, met_from_back;

  friend bool operator==(const RayLaneMasks&, const RayLaneMasks&) = default;
};

/// The certified test, as compiled for each instruction set.
namespace avx2 {
RayLaneMasks ray_lanes(const Vec3& origin, const Vec3& direction, const RayLaneCorners& corners);
}
namespace simd128 {
RayLaneMasks ray_lanes(const Vec3& origin, const Vec3& direction, const RayLaneCorners& corners);
}
namespace scalar {
RayLaneMasks ray_lanes(const Vec3& origin, const Vec3& direction, const RayLaneCorners& corners);
}

}  // namespace pelt::test
