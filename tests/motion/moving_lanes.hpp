#pragma once

#include "geometry/triage_lanes.hpp"

namespace pelt::test {

/// The vertices of eight pairs of triangles at both ends of a step.
struct MovingLanes {
  LaneCorners from, to;
};

/// The certified test of moving triangles, as compiled for each instruction set.
namespace avx2 {
LaneMasks moving_triage_lanes(const MovingLanes& lanes);
}
namespace simd128 {
LaneMasks moving_triage_lanes(const MovingLanes& lanes);
}
namespace scalar {
LaneMasks moving_triage_lanes(const MovingLanes& lanes);
}

}  // namespace pelt::test
