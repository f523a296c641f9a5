/// Compiled once for each target, so that the test itself runs on any machine.
#include "apart_lanes.hpp"

#include "geometry/triangle_apart.hpp"
#include "lane_pairs.hpp"

namespace pelt::test {
namespace PELT_TARGET {

LaneGaps apart_lanes(const LaneCorners& corners) {
  const detail::Apart8 apart = detail::how_far_apart(lane_pairs(corners));
  LaneGaps gaps;
  apart.at_least.store(gaps.at_least);
  apart.about.store(gaps.about);
  return gaps;
}

}  // namespace PELT_TARGET
}  // namespace pelt::test
