#pragma once

#include "geometry/triangle_pair.hpp"
#include "support/compiled.hpp"

#include <algorithm>
#include <array>

namespace pelt::test {

/// The vertices of eight pairs of triangles: those of pair i are [triangle][vertex][i], four floats
/// of which the last is unused.
using LaneCorners = float[2][3][8][4];

struct LaneMasks {
  unsigned apart, intersecting;

  friend bool operator==(const LaneMasks&, const LaneMasks&) = default;
};

/// The certified test.
using TriageLanes = LaneMasks(const LaneCorners& corners);
PELT_DECLARE_COMPILED(TriageLanes, triage_lanes)

using TrianglePair = std::array<detail::TriangleCorners, 2>;

/// The same two triangles with eight orders of vertices.
inline std::array<TrianglePair, 8> turned(const detail::TriangleCorners& a,
                                          const detail::TriangleCorners& b) {
  std::array<TrianglePair, 8> pairs;
  for (std::size_t lane = 0; lane < 8; ++lane)
    for (std::size_t i = 0; i < 3; ++i) {
      pairs[lane][lane % 2][i] = a[(i + lane) % 3];
      pairs[lane][1 - lane % 2][i] = b[(i + lane / 3) % 3];
    }
  return pairs;
}

inline LaneCorners& fill(LaneCorners& lanes, const std::array<TrianglePair, 8>& pairs) {
  for (std::size_t lane = 0; lane < 8; ++lane)
    for (std::size_t t = 0; t < 2; ++t)
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3& p = pairs[lane][t][corner];
        const float xyz[4] = {p.x, p.y, p.z, 0};
        std::copy(xyz, xyz + 4, lanes[t][corner][lane]);
      }
  return lanes;
}

}  // namespace pelt::test
