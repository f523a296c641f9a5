/// Compiled once for each instruction set. The test itself runs on any machine.
#include "moving_lanes.hpp"

#include "geometry/lane_pairs.hpp"
#include "motion/moving_triage.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

LaneMasks moving_triage_lanes(const MovingLanes& lanes) {
  const detail::MovingPairs8 pairs = {lane_pairs(lanes.from), lane_pairs(lanes.to)};
  const detail::Triage triage = detail::moving_triage(pairs, detail::times_of_boxes(pairs), 0xFF);
  return {triage.apart, triage.intersecting};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
