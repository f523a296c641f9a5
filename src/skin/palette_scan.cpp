#include "skin/palette_scan.hpp"

#include "base/float8.hpp"

#include <limits>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

float largest_coordinate(const Float4& v) {
  const float xy = v[0] > v[1] ? v[0] : v[1];
  return xy > v[2] ? xy : v[2];
}

}  // namespace

PaletteScan scan_palette(const float* floats, std::size_t joint_count) {
  const Float8 last_columns(Float4(0.0f), Float4(0, 0, 0, 1));
  const Float8 most(std::numeric_limits<float>::max());
  Float8 xy_largest(0.0f), zt_largest(0.0f), sum_largest(0.0f);
  Mask8 finite = sum_largest <= most;
  for (const float* m = floats; m != floats + 16 * joint_count; m += 16) {
    const Float8 xy = load8(m), zt = load8(m + 8);
    const Float8 sum = abs(xy) + abs(zt - last_columns);
    xy_largest = max(xy_largest, abs(xy));
    zt_largest = max(zt_largest, abs(zt));
    sum_largest = max(sum_largest, sum);
    finite = finite & (sum <= most);  // false for NaN, too
  }
  const Float4 last_rows = fold(sum_largest);
  const Float4 linear = max(max(xy_largest.low(), xy_largest.high()), zt_largest.low());
  return {largest_coordinate(linear), largest_coordinate(zt_largest.high()),
          last_rows[3] == 0 && finite.bits() == 0xFF};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
