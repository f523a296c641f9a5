#pragma once

#include <pelt/math.hpp>
#include <pelt/result.hpp>

#include "skin/morph_weights.hpp"
#include "skin/palette_scan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// The largest extent of any palette, four times kMaxCoordinate. When a palette is set no joint
/// alone throws a rest position beyond kMaxCoordinate; but one may stretch while another moves
/// away, which together makes twice that. A new palette has the rest extent, of three coordinates.
/// The rest is for rounding.
inline constexpr float kMaxExtent = 0x1p62f;

/// A mesh counts as no smaller: what throws it no further than kMaxCoordinate then has no element
/// beyond 2^120, and no blend of such matrices overflows.
inline constexpr float kLeastRestExtent = 0x1p-60f;

/// The floats of matrices that stand side by side.
inline std::span<const float> floats_of(std::span<const Matrix4> matrices) {
  return {reinterpret_cast<const float*>(matrices.data()), 16 * matrices.size()};
}

/// A joint palette that has been checked, and the morph weights that it goes with: finite, affine,
/// and throwing no rest position, displaced by morph targets, beyond kMaxCoordinate, so that no
/// query meets NaN or infinity.
class Palette {
 public:
  /// Identity matrices, for a mesh of that `rest_extent`, which is less than kMaxExtent, and with
  /// morph targets of these extents; all weights are zero.
  Palette(std::uint32_t joint_count, float rest_extent, std::span<const float> morph_extents = {});

  /// Takes `floats`, 16 for each joint, or says what is wrong with them and changes nothing.
  Result<void> set(std::span<const float> floats);
  Result<void> set(std::span<const Matrix4> matrices) { return set(floats_of(matrices)); }

  /// The same for the weights of the morph targets.
  Result<void> set_morph_weights(std::span<const float> weights);

  std::span<const Matrix4> joints() const { return joints_; }
  const Matrix4& operator[](std::uint32_t joint) const { return joints_[joint]; }

  const MorphWeights& morphs() const { return morphs_; }

  /// M of the rounding analyses: for every joint and every point v of the mesh's rest box,
  /// sum_b |A_ab| |v_b| + |t_a| <= M; for |v_b| the magnitudes of all weighted displacements of a
  /// vertex count, too, be they added or subtracted. No coordinate of a posed vertex is larger, and
  /// float32 rounding of posed vertices and bounds is a small multiple of 2^-24 M. At most
  /// kMaxExtent, and never so small that what underflows counts beside that rounding.
  float extent() const { return extent_; }

  /// No vertex is posed further from the origin.
  float reach() const { return extent_ * 1.7320510f; }

  std::size_t memory_bytes() const { return joints().size_bytes() + morphs_.memory_bytes(); }

 private:
  bool are_good(const PaletteScan& joints, double reach) const;
  Problem find_bad_joint(std::span<const float> floats, double reach) const;

  std::vector<Matrix4> joints_;
  PaletteScan scan_ = {.linear = 1};  // of the joints
  MorphWeights morphs_;
  float rest_extent_;
  double reach_;  // the rest extent and that of the weighted displacements
  float extent_;
};

}  // namespace pelt::detail
