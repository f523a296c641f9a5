#pragma once

/// A box in two vectors of four floats.

#include "base/float4.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A box by its low and high corners. The fourth lanes are meaningless.
struct Box4 {
  Float4 low, high;
};

/// Returns the empty box.
inline Box4 empty_box() { return {Float4(HUGE_VALF), Float4(-HUGE_VALF)}; }

inline Box4 unite(const Box4& a, const Box4& b) { return {min(a.low, b.low), max(a.high, b.high)}; }
inline Box4 intersect(const Box4& a, const Box4& b) {
  return {max(a.low, b.low), min(a.high, b.high)};
}

/// Returns half the surface area of a box, in double, so that products of extents do not overflow.
inline double half_area(const Box4& box) {
  const Float4 size = box.high - box.low;
  const double x = size[0], y = size[1], z = size[2];
  return x * y + y * z + z * x;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
