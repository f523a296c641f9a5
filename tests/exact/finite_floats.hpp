#pragma once

#include "geometry/triangle_cases.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pelt::test {

/// Any finite bit pattern; all exponents are equally likely.
inline float any_finite_float(Random& random) {
  while (true) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) return value;
  }
}

/// Floats of all magnitudes from a short list, so that many are equal.
inline float one_of_few_floats(Random& random) {
  constexpr std::array kFew = {0.0f, -0.0f,    0x1p-149f,        -0x1p-149f,       0x1p-126f,
                               1.0f, -1.0f,    1.0f + 0x1p-23f,  -1.0f - 0x1p-23f, 0x1p-25f,
                               3e9f, -0x1p60f, 0x1.fffffep+127f, -0x1.fffffep+127f};
  return kFew[random() % kFew.size()];
}

inline detail::TriangleCorners corners_of(Random& random, float (*coordinate)(Random&)) {
  detail::TriangleCorners corners;
  for (Vec3& p : corners) {
    p.x = coordinate(random);
    p.y = coordinate(random);
    p.z = coordinate(random);
  }
  return corners;
}

}  // namespace pelt::test
