/// Compiled once for each instruction set. The test itself runs on any machine.
#include "triage_lanes.hpp"

#include "geometry/triangle_triage.hpp"
#include "lane_pairs.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

LaneMasks triage_lanes(const LaneCorners& corners) {
  const detail::Triage triage = detail::triage(lane_pairs(corners));
  return {triage.apart, triage.intersecting};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
