/// Compiled once for each instruction set. The test itself runs on any machine.
#include "separation_lanes.hpp"

#include "geometry/lane_pairs.hpp"
#include "self/neighbour_gaps.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

LaneSeparations separation_lanes(const LaneCorners& corners) {
  LaneSeparations result;
  detail::separations(lane_pairs(corners)).store(result.data());
  return result;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
