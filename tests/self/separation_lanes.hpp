#pragma once

#include "geometry/triage_lanes.hpp"

#include <array>

namespace pelt::test {

using LaneSeparations = std::array<float, 8>;

/// Lower bounds of the distances of eight pairs, as compiled for each instruction set.
namespace avx2 {
LaneSeparations separation_lanes(const LaneCorners& corners);
}
namespace simd128 {
LaneSeparations separation_lanes(const LaneCorners& corners);
}
namespace scalar {
LaneSeparations separation_lanes(const LaneCorners& corners);
}

}  // namespace pelt::test
