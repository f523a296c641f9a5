/// Compiled once for each target, so that the test itself runs on any machine.
#include "apart_lanes.hpp"

#include "geometry/triangle_apart.hpp"

namespace pelt::test {
namespace {

detail::Points8 points(const float (&p)[8][4]) {
  using detail::load4;
  return detail::transpose8(load4(p[0]), load4(p[1]), load4(p[2]), load4(p[3]), load4(p[4]),
                            load4(p[5]), load4(p[6]), load4(p[7]));
}

}  // namespace

namespace PELT_TARGET {

LaneGaps apart_lanes(const LaneCorners& corners) {
  detail::TrianglePairs8 pairs;
  for (int i = 0; i < 3; ++i) {
    pairs.a[i] = points(corners[0][i]);
    pairs.b[i] = points(corners[1][i]);
  }
  const detail::Apart8 apart = detail::how_far_apart(pairs);
  LaneGaps gaps;
  apart.at_least.store(gaps.at_least);
  apart.about.store(gaps.about);
  return gaps;
}

}  // namespace PELT_TARGET
}  // namespace pelt::test
