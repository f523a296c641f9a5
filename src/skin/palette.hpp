#pragma once

/// The joint palette, morph weights and offsets of an instance.

#include <pelt/math.hpp>
#include <pelt/result.hpp>

#include "base/bytes_held.hpp"
#include "base/problem.hpp"
#include "skin/dual_skin.hpp"
#include "skin/joint_link.hpp"
#include "skin/palette_lanes.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Validated weights of a mesh's morph targets in a pose: finite, and displacing no vertex farther
/// than kMaxCoordinate. Initially all zero.
class MorphWeights {
 public:
  /// `extents` [M]: for each target the sum over the axes of its largest displacement.
  explicit MorphWeights(std::span<const float> extents);

  /// Validates `weights` without storing them. Returns an empty Problem if they are valid.
  Problem check(std::span<const float> weights) const;

  /// Stores the weights. Precondition: `check` returns no problem.
  void set(std::span<const float> weights);

  std::size_t count() const { return weights_.size(); }
  std::span<const float> all() const { return weights_; }
  float operator[](std::uint32_t target) const { return weights_[target]; }

  /// The targets with nonzero weight, in ascending order.
  std::span<const std::uint32_t> active() const { return active_; }
  bool any() const { return !active_.empty(); }

  /// Sum of |weight| x extent, an upper bound of the sum of coordinates of any displacement.
  double extent_of(std::span<const float> weights) const;

  std::size_t memory_bytes() const;

 private:
  std::vector<float> extents_, weights_;
  std::vector<std::uint32_t> active_;
};

/// Largest extent of any palette, four times kMaxCoordinate. No single joint of a palette moves a
/// rest position beyond kMaxCoordinate. One joint may stretch and another may translate, however,
/// which together makes twice that. A new palette has the rest extent, a sum of three coordinates.
/// The remainder allows for rounding.
inline constexpr float kMaxExtent = 0x1p62f;

/// Smallest rest extent used for the checks. A matrix that moves a mesh of this size at most to
/// kMaxCoordinate has no element beyond 2^120, and no blend of such matrices overflows.
inline constexpr float kLeastRestExtent = 0x1p-60f;

/// The floats of an array of matrices.
inline std::span<const float> floats_of(std::span<const Matrix4> matrices) {
  return {reinterpret_cast<const float*>(matrices.data()), 16 * matrices.size()};
}

/// A validated joint palette with its morph weights, and offsets that are valid whatever they are
/// (see skin.hpp). Matrices are finite and affine, and move no displaced rest position beyond
/// kMaxCoordinate, so queries never see NaN or infinity.
class Palette {
 public:
  /// Identity matrices and zero weights, for a mesh with this `rest_extent` and with morph targets
  /// of these extents. `dual_influences` is the largest number of influences of a vertex if the
  /// mesh has dual quaternion skinning, otherwise zero; `links` are then those of the mesh, which
  /// only bounds need. Precondition: rest_extent < kMaxExtent.
  Palette(std::uint32_t joint_count, float rest_extent, std::span<const float> morph_extents = {},
          std::uint32_t dual_influences = 0, std::span<const JointLink> links = {});

  /// Copies the matrices if they are valid; otherwise returns an error and changes nothing.
  Result<void> set(const JointMatrices& matrices);

  /// The same for dual quaternions, eight floats per joint. An error if the mesh has linear blend
  /// skinning.
  Result<void> set_dual_quaternions(std::span<const float> floats);

  /// Copies the weights of the morph targets, in the same way.
  Result<void> set_morph_weights(std::span<const float> weights);

  std::span<const Matrix4> joints() const { return joints_; }
  const Matrix4& operator[](std::uint32_t joint) const { return joints_[joint]; }

  /// Whether the mesh has dual quaternion skinning. The dual quaternions then define the posed
  /// vertices, and the matrices above are rounded from them.
  bool is_dual() const { return !duals_.empty(); }
  std::span<const DualQuaternion> duals() const { return duals_; }
  std::uint32_t dual_influences() const { return dual_influences_; }

  /// Rounding of the difference of the images of a rest position under two joints; see
  /// model/node_bounds.hpp.
  float link_slack() const {
    return 0x1p-18f * extent_ * static_cast<float>(1 + morphs_.active().size());
  }

  /// Whether no dual quaternion counts negated in any vertex; false if this is not known.
  bool negates_none() const { return !links_.empty() && !(link_hull_.least_cosine < 0); }

  std::span<const JointLink> links() const { return links_; }
  std::span<const LinkMotion> link_motions() const { return link_motions_; }  ///< one per link
  const LinkHull& link_hull() const { return link_hull_; }

  const MorphWeights& morphs() const { return morphs_; }

  /// Offsets of the vertices [V], borrowed from the caller, or none: then `data` is null, also for
  /// an empty array that has memory.
  std::span<const Vec3> offsets() const { return offsets_; }
  void set_offsets(std::span<const Vec3> offsets) {
    offsets_ = offsets.empty() ? std::span<const Vec3>() : offsets;
  }

  /// M of the rounding analyses: sum_b |A_ab| |v_b| + |t_a| <= M for every joint (A | t) and every
  /// point v of the mesh's rest box, where |v_b| includes the magnitudes of all weighted
  /// displacements of a vertex. No coordinate of a posed vertex without offset is larger than M,
  /// and float32 rounding of posed vertices and bounds is a small multiple of 2^-24 M. At most
  /// kMaxExtent, and large enough that underflow is negligible beside this rounding.
  ///
  /// With dual quaternion skinning, a blended rotation moves v no farther than the sum of |v_b|,
  /// and a blended translation is at most K times as long as the longest of the joints (see
  /// dual_skin.hpp). M is the first sum plus 1.76 K times the largest coordinate of a translation,
  /// where 1.76 is slightly more than the root of three.
  float extent() const { return extent_; }

  /// Upper bound of the distance of any posed vertex without offset from the origin.
  float reach() const { return extent_ * 1.7320510f; }

  std::size_t memory_bytes() const {
    return bytes_held(joints_, duals_, next_joints_, next_duals_, links_, link_motions_,
                      aligned_with_) +
           morphs_.memory_bytes();
  }

 private:
  template <typename ProblemOf>
  Problem first_problem(const ProblemOf& problem_of) const;

  bool are_good(const PaletteScan& joints, double reach) const;
  Problem find_bad_joint(std::span<const float> floats, double reach) const;
  float extent_of(const PaletteScan& joints, double reach) const;
  void keep(const PaletteScan& scan);

  Result<void> set_form(std::span<const float> floats);
  Result<void> set_form(std::span<const Matrix4> matrices);
  Result<void> set_form(std::span<const Matrix3x4> matrices);
  Result<void> set_form(std::span<const double> numbers);

  template <typename MatrixOf>
  Result<void> set_by(const MatrixOf& matrix_of);

  Result<void> set_rigid(const float* matrices);
  Result<void> take_next_duals();
  void align_next_duals();

  std::vector<Matrix4> joints_;
  std::vector<DualQuaternion> duals_;  // empty with linear blend skinning
  PaletteScan scan_ = {.linear = 1};   // of the joints
  MorphWeights morphs_;
  std::span<const Vec3> offsets_;
  std::uint32_t dual_influences_;
  float rest_extent_;
  double reach_;  // rest extent plus the extent of the weighted displacements
  float extent_;

  std::vector<JointLink> links_;
  std::vector<std::uint16_t> aligned_with_;  // by joint: one before it whose sign it follows, or 0
  std::vector<LinkMotion> link_motions_;
  LinkHull link_hull_;

  // The next joints, until they are found valid; empty with linear blend skinning.
  std::vector<Matrix4> next_joints_;
  std::vector<DualQuaternion> next_duals_;
};

}  // namespace pelt::detail
