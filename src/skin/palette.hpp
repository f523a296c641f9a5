#pragma once

#include <pelt/math.hpp>
#include <pelt/result.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// The floats of matrices that stand side by side.
inline std::span<const float> floats_of(std::span<const Matrix4> matrices) {
  return {reinterpret_cast<const float*>(matrices.data()), 16 * matrices.size()};
}

/// A joint palette that has been checked: finite, affine, and throwing no rest position beyond
/// kMaxCoordinate, so that no query meets NaN or infinity.
class Palette {
 public:
  /// Identity matrices, for a mesh of that `rest_extent`.
  Palette(std::uint32_t joint_count, float rest_extent);

  /// Takes `floats`, 16 for each joint, or says what is wrong with them and changes nothing.
  Result<void> set(std::span<const float> floats);
  Result<void> set(std::span<const Matrix4> matrices) { return set(floats_of(matrices)); }

  std::span<const Matrix4> joints() const { return joints_; }
  const Matrix4& operator[](std::uint32_t joint) const { return joints_[joint]; }

  /// M of the rounding analyses: for every joint and every point v of the mesh's rest box,
  /// sum_b |A_ab| |v_b| + |t_a| <= M. No coordinate of a posed vertex is larger, and float32
  /// rounding of posed vertices and bounds is a small multiple of 2^-24 M. Never so small that what
  /// underflows counts beside that.
  float extent() const { return extent_; }

  /// No vertex is posed further from the origin.
  float reach() const { return extent_ * 1.7320510f; }

 private:
  std::vector<Matrix4> joints_;
  float rest_extent_;
  float extent_;
};

}  // namespace pelt::detail
