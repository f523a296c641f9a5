#pragma once

#include <pelt/math.hpp>
#include <pelt/result.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// A joint palette that has been checked: finite, affine, and throwing no rest position beyond
/// kMaxCoordinate, so that no query meets NaN or infinity.
class Palette {
 public:
  /// Identity matrices. No rest position is further than `rest_radius` from the origin.
  Palette(std::uint32_t joint_count, float rest_radius);

  /// Takes `floats`, 16 for each joint, or says what is wrong with them and changes nothing.
  Result<void> set(std::span<const float> floats);

  std::span<const Matrix4> joints() const { return joints_; }
  const Matrix4& operator[](std::uint32_t joint) const { return joints_[joint]; }

  /// G of the rounding analysis: max over joints of |A_j|_F R + |t_j| with R the rest radius. No
  /// vertex is posed further from the origin, and float32 rounding of posed vertices and bounds is
  /// a small multiple of 2^-24 G.
  float reach() const { return reach_; }

 private:
  std::vector<Matrix4> joints_;
  float rest_radius_;
  float reach_;
};

}  // namespace pelt::detail
