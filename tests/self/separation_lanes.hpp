#pragma once

#include "geometry/triage_lanes.hpp"

#include <array>

namespace pelt::test {

using LaneSeparations = std::array<float, 8>;

/// Lower bounds of the distances of eight pairs.
using SeparationLanes = LaneSeparations(const LaneCorners& corners);
PELT_DECLARE_COMPILED(SeparationLanes, separation_lanes)

}  // namespace pelt::test
