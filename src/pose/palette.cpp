#include "pose/palette.hpp"

#include "model/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace pelt::detail {
namespace {

/// |A|_F R + |t| of one joint, rounded up. Not finite when the matrix is not, or nearly overflows.
double joint_reach(const float* m, double rest_radius) {
  double linear = 0, translation = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      const double a = m[4 * column + row];
      linear += a * a;
    }
  for (int row = 0; row < 3; ++row) {
    const double t = m[12 + row];
    translation += t * t;
  }
  return (std::sqrt(linear) * rest_radius + std::sqrt(translation)) * (1 + 0x1p-40);
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
Palette::Palette(std::uint32_t joint_count, float rest_radius)
    : joints_(joint_count), rest_radius_(std::max(rest_radius, 0x1p-60f)) {
  const double radius = static_cast<double>(rest_radius_);
  reach_ = std::nextafter(static_cast<float>(joint_reach(joints_[0].m.data(), radius)),
                          std::numeric_limits<float>::infinity());
}

Result<void> Palette::set(std::span<const float> floats) {
  if (floats.size() != joints_.size() * 16) return wrong_size(floats.size(), joints_.size());
  double reach = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const float* m = floats.data() + 16 * j;
    const double joint = joint_reach(m, static_cast<double>(rest_radius_));
    if (!(joint <= static_cast<double>(kMaxCoordinate)) || !has_affine_last_row(m))
      return describe(m, j);
    reach = std::max(reach, joint);
  }
  std::memcpy(joints_.data()->m.data(), floats.data(), floats.size_bytes());
  reach_ = std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::infinity());
  return {};
}

}  // namespace pelt::detail
