#pragma once

#include <pelt/math.hpp>
#include "support/compiled.hpp"

namespace pelt::test {

/// The vertices of eight triangles: vertex k of triangle i is [k][i], four floats of which the last
/// is unused.
using RayLaneCorners = float[3][8][4];

/// One bit for each triangle.
struct RayLaneMasks {
  unsigned missed, met_from_front, met_from_back;

  friend bool operator==(const RayLaneMasks&, const RayLaneMasks&) = default;
};

/// The certified test.
using RayLanes = RayLaneMasks(const Vec3& origin, const Vec3& direction,
                              const RayLaneCorners& corners);
PELT_DECLARE_COMPILED(RayLanes, ray_lanes)

}  // namespace pelt::test
