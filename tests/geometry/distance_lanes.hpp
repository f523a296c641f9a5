#pragma once

#include "triage_lanes.hpp"

#include <array>

namespace pelt::test {

using LaneDistances = std::array<double, 8>;

/// Squared distances of eight pairs.
using DistanceLanes = LaneDistances(const LaneCorners& corners);
PELT_DECLARE_COMPILED(DistanceLanes, distance_lanes)

}  // namespace pelt::test
