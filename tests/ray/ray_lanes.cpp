/// Compiled once for each instruction set. The test itself runs on any machine.
#include "ray_lanes.hpp"

#include "ray/ray_triage.hpp"

namespace pelt::test::PELT_INSTRUCTION_SET {

RayLaneMasks ray_lanes(const Vec3& origin, const Vec3& direction, const RayLaneCorners& corners) {
  using detail::load4;
  const auto corner = [&](int k) {
    const auto& p = corners[k];
    return detail::transpose8(load4(p[0]), load4(p[1]), load4(p[2]), load4(p[3]), load4(p[4]),
                              load4(p[5]), load4(p[6]), load4(p[7]));
  };
  const detail::RayTriage known = detail::triage(detail::shear(origin, direction), corner);
  return {known.missed, known.met_from_front, known.met_from_back};
}

}  // namespace pelt::test::PELT_INSTRUCTION_SET
