#pragma once

#include "triage_lanes.hpp"

namespace pelt::test {

struct LaneGaps {
  float at_least[8], about[8];
};

/// Certified lower bounds of distances as compiled for each target.
namespace avx2 {
LaneGaps apart_lanes(const LaneCorners& corners);
}
namespace simd128 {
LaneGaps apart_lanes(const LaneCorners& corners);
}
namespace scalar {
LaneGaps apart_lanes(const LaneCorners& corners);
}

}  // namespace pelt::test
