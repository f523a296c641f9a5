#pragma once

#include "geometry/triangle_triage.hpp"
#include "triage_lanes.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

inline detail::Points8 lane_points(const float (&p)[8][4]) {
  using detail::load4;
  return detail::transpose8(load4(p[0]), load4(p[1]), load4(p[2]), load4(p[3]), load4(p[4]),
                            load4(p[5]), load4(p[6]), load4(p[7]));
}

/// The eight pairs in the layout of the wide code.
inline detail::TrianglePairs8 lane_pairs(const LaneCorners& corners) {
  detail::TrianglePairs8 pairs;
  for (int i = 0; i < 3; ++i) {
    pairs.a[i] = lane_points(corners[0][i]);
    pairs.b[i] = lane_points(corners[1][i]);
  }
  return pairs;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
