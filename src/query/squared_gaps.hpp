#pragma once

/// Distances of boxes, eight at a time.

#include "base/float8.hpp"
#include "query/lanes.hpp"

#include <cstddef>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

[[gnu::always_inline]] inline Float8 gap(const Float8& low_a, const Float8& high_a,
                                         const Float8& low_b, const Float8& high_b) {
  return max(max(low_a - high_b, low_b - high_a), Float8(0.0f));
}

/// The squared distance of the boxes in each lane. Both arguments are Box8 or Boxes8.
template <typename BoxA, typename BoxB>
[[gnu::always_inline]] inline Float8 squared_gap(const BoxA& a, const BoxB& b) {
  const Float8 x = gap(a.low[0], a.high[0], b.low[0], b.high[0]);
  const Float8 y = gap(a.low[1], a.high[1], b.low[1], b.high[1]);
  const Float8 z = gap(a.low[2], a.high[2], b.low[2], b.high[2]);
  return x * x + y * y + z * z;
}

/// Returns the squared distances from `box` of the boxes starting at lane `first`, with a small
/// error in either direction (reach.hpp).
template <std::size_t kCount>
[[gnu::always_inline]] inline Float8 squared_gaps(const float (&low)[3][kCount],
                                                  const float (&high)[3][kCount], unsigned first,
                                                  const Box8& box) {
  return squared_gap(load_boxes(low, high, first), box);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
