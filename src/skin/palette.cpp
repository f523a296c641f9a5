#include "skin/palette.hpp"

#include "base/assert.hpp"
#include "base/problem.hpp"
#include "base/wide_code.hpp"
#include "skin/palette_scan.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pelt::detail {
namespace {

static_assert(kMaxExtent == 4 * kMaxCoordinate);

/// Linear parts count as no smaller, so that what underflows in products with them is far below the
/// rounding of M.
constexpr double kLeastLinear = 0x1p-100;

/// M of the joints scanned, rounded up; not finite when an element is not or nearly overflows.
float extent_of(const PaletteScan& scan, float rest_extent) {
  const double sum =
      std::max(double{scan.linear}, kLeastLinear) * double{rest_extent} + double{scan.translation};
  return std::nextafter(static_cast<float>(sum), std::numeric_limits<float>::infinity());
}

bool has_affine_last_row(const float* m) {
  return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
}

/// Why the matrix of a joint is refused.
Problem describe(const float* m, std::size_t joint) {
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(m[i]))
      return problem("palette[%zu] has the element %g at row %d, column %d", joint,
                     static_cast<double>(m[i]), i % 4, i / 4);
  if (!has_affine_last_row(m))
    return problem(
        "palette[%zu] has the last row %g %g %g %g, expected 0 0 0 1 (is the matrix row-major?)",
        joint, static_cast<double>(m[3]), static_cast<double>(m[7]), static_cast<double>(m[11]),
        static_cast<double>(m[15]));
  return problem("palette[%zu] can move a vertex beyond 2^60 units", joint);
}

}  // namespace

Palette::Palette(std::uint32_t joint_count, float rest_extent)
    : joints_(joint_count), rest_extent_(std::max(rest_extent, kLeastRestExtent)) {
  extent_ = extent_of({.linear = 1}, rest_extent_);
  PELT_ASSERT(extent_ <= kMaxExtent);
}

Result<void> Palette::set(std::span<const float> floats) {
  if (floats.size() != joints_.size() * 16)
    return invalid_argument(
        problem("the palette has %zu floats, expected %zu: 16 for each of the model's %zu joints",
                floats.size(), 16 * joints_.size(), joints_.size()));
  const auto is_good = [&](const PaletteScan& scan) {
    return scan.is_affine && extent_of(scan, rest_extent_) <= kMaxCoordinate;
  };
  const PaletteScan scan = wide_code().scan_palette(floats.data(), joints_.size());
  if (!is_good(scan))
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (!is_good(wide_code().scan_palette(&floats[16 * j], 1)))
        return invalid_argument(describe(&floats[16 * j], j));
  std::memcpy(joints_.data()->m.data(), floats.data(), floats.size_bytes());
  extent_ = extent_of(scan, rest_extent_);
  return {};
}

}  // namespace pelt::detail
