#pragma once

#include "triage_lanes.hpp"

#include <array>

namespace pelt::test {

using LaneDistances = std::array<double, 8>;

/// Squared distances of eight pairs, as compiled for each instruction set.
namespace avx2 {
LaneDistances distance_lanes(const LaneCorners& corners);
}
namespace simd128 {
LaneDistances distance_lanes(const LaneCorners& corners);
}
namespace scalar {
LaneDistances distance_lanes(const LaneCorners& corners);
}

}  // namespace pelt::test
