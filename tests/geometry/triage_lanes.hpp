#pragma once

namespace pelt::test {

/// The vertices of eight pairs of triangles: those of pair i are [triangle][vertex][i], four floats
/// of which the last is unused.
using LaneCorners = float[2][3][8][4];

struct LaneMasks {
  unsigned apart, intersecting;

  friend bool operator==(const LaneMasks&, const LaneMasks&) = default;
};

/// The certified test, as compiled for each instruction set.
namespace avx2 {
LaneMasks triage_lanes(const LaneCorners& corners);
}
namespace simd128 {
LaneMasks triage_lanes(const LaneCorners& corners);
}
namespace scalar {
LaneMasks triage_lanes(const LaneCorners& corners);
}

}  // namespace pelt::test
