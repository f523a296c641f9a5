#pragma once

#include "geometry/triage_lanes.hpp"

namespace pelt::test {

/// The vertices of eight pairs of triangles at both ends of a step.
struct MovingLanes {
  LaneCorners from, to;
};

/// The certified test of moving triangles.
using MovingTriageLanes = LaneMasks(const MovingLanes& lanes);
PELT_DECLARE_COMPILED(MovingTriageLanes, moving_triage_lanes)

}  // namespace pelt::test
