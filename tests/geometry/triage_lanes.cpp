/// Compiled once for each target. The test itself runs on any machine.
#include "triage_lanes.hpp"

#include "geometry/triangle_triage.hpp"
#include "lane_pairs.hpp"

namespace pelt::test {
namespace PELT_TARGET {

LaneMasks triage_lanes(const LaneCorners& corners) {
  const detail::Triage triage = detail::triage(lane_pairs(corners));
  return {triage.apart, triage.intersecting};
}

}  // namespace PELT_TARGET
}  // namespace pelt::test
