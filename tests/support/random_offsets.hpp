#pragma once

/// Offsets of posed vertices, and their caps, for tests.

#include "support/random.hpp"

#include <pelt/math.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace pelt::test {

using Caps = std::vector<float>;

/// Caps up to `size`, a quarter of them 0.
inline Caps random_caps(Random& random, std::size_t count, double size) {
  Caps caps(count);
  for (float& cap : caps) cap = random.chance(0.25) ? 0 : random.uniformf(0, size);
  return caps;
}

/// To and beyond the cap; also infinite, zero, or NaN.
inline float random_offset(Random& random, float cap) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  switch (random.index(8)) {
    case 0:
      return random.chance(0.5) ? kNan : -kNan;
    case 1:
      return random.chance(0.5) ? kInfinity : -kInfinity;
    case 2:
      return random.chance(0.5) ? cap : -cap;
    case 3:
      return random.chance(0.5) ? 0.0f : -0.0f;
    default:
      return random.uniformf(-2, 2) * cap;
  }
}

inline std::vector<Vec3> random_offsets(Random& random, const Caps& caps) {
  std::vector<Vec3> offsets;
  for (const float cap : caps) {
    const float x = random_offset(random, cap), y = random_offset(random, cap);
    offsets.push_back({x, y, random_offset(random, cap)});
  }
  return offsets;
}

}  // namespace pelt::test
