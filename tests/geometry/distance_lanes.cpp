/// Compiled once for each instruction set. The test itself runs on any machine.
#include "distance_lanes.hpp"

#include "distance/triangle_gaps.hpp"
#include "lane_pairs.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

LaneDistances distance_lanes(const LaneCorners& corners) {
  double squared[8];
  detail::squared_distances(lane_pairs(corners), 8, squared);
  LaneDistances distances;
  for (int i = 0; i < 8; ++i) distances.data()[i] = squared[i];
  return distances;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
