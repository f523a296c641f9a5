#pragma once

#include "support/compiled.hpp"

#include <cstdint>

namespace pelt::test {

/// Results of the operations of base/float8.hpp on two rows of eight floats. Masks have one bit per
/// lane.
struct LaneResults {
  float sum[8], difference[8], product[8], product_and_sum[8], least[8], most[8], size[8];
  unsigned less, less_equal, both, either, one_of_both;
  float chosen[8];  ///< of a where a is less, otherwise of b
  float repeated[8], paired[8], low[4], high[4], joined[8], folded[4];
};

/// Results of the operations of base/short16.hpp on two rows of sixteen integers, and on a row of
/// sixteen floats. Masks have one bit per lane.
struct ShortResults {
  std::int16_t first[16], both[16], repeated[16], truncated[16];
  unsigned greater, equal, either;
};

/// Points 0 to 7, four floats each, transposed to coordinates.
struct TurnedPoints {
  float x[8], y[8], z[8];
};

using LaneOperations = LaneResults(const float* a, const float* b);
using ShortOperations = ShortResults(const std::int16_t* a, const std::int16_t* b,
                                     const float* floats);
using TurnPoints = TurnedPoints(const float* points);

// Addresses need no alignment.
PELT_DECLARE_COMPILED(LaneOperations, lane_operations)
PELT_DECLARE_COMPILED(ShortOperations, short_operations)
PELT_DECLARE_COMPILED(TurnPoints, turn_points)

}  // namespace pelt::test
