#include "skin/palette.hpp"

#include "base/float4.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace pelt::detail {
namespace {

/// Linear parts count as no smaller, so that what underflows in products with them is far below the
/// rounding of M.
constexpr double kLeastLinear = 0x1p-100;

/// What a scan of joint matrices finds.
struct Scan {
  float linear = 0, translation = 0;  ///< largest elements
  bool affine = true;                 ///< last rows are 0 0 0 1, and all elements are finite

  /// M of the joints scanned, rounded up; not finite when an element is not or nearly overflows.
  float extent(float rest_extent) const {
    const double sum =
        std::max(double{linear}, kLeastLinear) * double{rest_extent} + double{translation};
    return std::nextafter(static_cast<float>(sum), std::numeric_limits<float>::infinity());
  }
};

float largest_coordinate(const Float4& v) { return std::max(std::max(v[0], v[1]), v[2]); }

Scan scan(std::span<const float> floats) {
  const Float4 last_column(0, 0, 0, 1);
  Float4 linear(0.0f), translation(0.0f), last_row(0.0f), poison(0.0f);
  for (const float* m = floats.data(); m != floats.data() + floats.size(); m += 16) {
    const Float4 x = load4(m), y = load4(m + 4), z = load4(m + 8), t = load4(m + 12);
    const Float4 ax = abs(x), ay = abs(y), az = abs(z);
    const Float4 sum = (ax + ay) + (az + abs(t - last_column));
    linear = max(max(linear, ax), max(ay, az));
    translation = max(translation, abs(t));
    last_row = max(last_row, sum);
    poison = poison + (sum - sum);  // NaN from the first element on that is not finite
  }
  const float poisoned = poison[0] + poison[1] + poison[2] + poison[3];
  return {largest_coordinate(linear), largest_coordinate(translation),
          last_row[3] == 0 && poisoned == 0};
}

bool has_affine_last_row(const float* m) {
  return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
}

Error describe(const float* m, std::size_t joint) {
  char text[160];
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(m[i])) {
      std::snprintf(text, sizeof text, "palette[%zu] has the element %g at row %d, column %d",
                    joint, static_cast<double>(m[i]), i % 4, i / 4);
      return {ErrorCode::invalid_argument, text};
    }
  if (!has_affine_last_row(m))
    std::snprintf(text, sizeof text,
                  "palette[%zu] has the last row %g %g %g %g, expected 0 0 0 1 (is the matrix "
                  "row-major?)",
                  joint, static_cast<double>(m[3]), static_cast<double>(m[7]),
                  static_cast<double>(m[11]), static_cast<double>(m[15]));
  else
    std::snprintf(text, sizeof text, "palette[%zu] can move a vertex beyond 2^60 units", joint);
  return {ErrorCode::invalid_argument, text};
}

Error wrong_size(std::size_t floats, std::size_t joints) {
  char text[160];
  std::snprintf(text, sizeof text,
                "the palette has %zu floats, expected %zu: 16 for each of the model's %zu joints",
                floats, 16 * joints, joints);
  return {ErrorCode::invalid_argument, text};
}

}  // namespace

/// A mesh counts as no smaller than 2^-60: what throws it no further than kMaxCoordinate then has
/// no element beyond 2^120, and no blend of such matrices overflows.
Palette::Palette(std::uint32_t joint_count, float rest_extent)
    : joints_(joint_count), rest_extent_(std::max(rest_extent, 0x1p-60f)) {
  extent_ = Scan{.linear = 1}.extent(rest_extent_);
}

Result<void> Palette::set(std::span<const float> floats) {
  if (floats.size() != joints_.size() * 16) return wrong_size(floats.size(), joints_.size());
  const auto is_good = [&](const Scan& found) {
    return found.affine && found.extent(rest_extent_) <= kMaxCoordinate;
  };
  const Scan all = scan(floats);
  if (!is_good(all))
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (!is_good(scan(floats.subspan(16 * j, 16)))) return describe(&floats[16 * j], j);
  std::memcpy(joints_.data()->m.data(), floats.data(), floats.size_bytes());
  extent_ = all.extent(rest_extent_);
  return {};
}

}  // namespace pelt::detail
