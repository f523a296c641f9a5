#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/model.hpp>

#include <memory>
#include <span>

namespace pelt {

namespace detail {
struct Pose;
}

/// One instance of a model: a joint palette, weights of morph targets, and the bounds that queries
/// have computed from both so far. To update a pose, call `set_palette`, `set_morph_weights` or
/// both, in any order. No separate refit is necessary: queries compute the bounds that they need.
///
/// A new pose has identity matrices and zero morph weights, so its posed vertices are the rest
/// positions. Queries store bounds in the pose, so only one thread at a time may query a pose.
/// Movable, not copyable. A moved-from pose may only be assigned to or destroyed.
class PELT_API Pose {
 public:
  /// Cost: O(J). Allocates the joint palette. Later, a query allocates if it opens more nodes than
  /// were open in any earlier frame; `reserve` prevents that.
  explicit Pose(SkinnedModel model);
  Pose(Pose&&) noexcept;
  Pose& operator=(Pose&&) noexcept;
  ~Pose();

  const SkinnedModel& model() const;

  /// Copies the joint palette. Matrix j transforms rest positions into the frame shared by all
  /// poses of a query. It is the product of three matrices, from left to right:
  /// - the world matrix of the instance,
  /// - the transform from the frame of joint j to the frame of the instance,
  /// - the inverse bind matrix of joint j.
  ///
  /// Cost: O(J). Allocates nothing.
  ///
  /// Returns an error and leaves the pose unchanged if
  /// - the number of matrices is not `model().joint_count()`,
  /// - an element of a matrix is not finite,
  /// - the last row of a matrix is not 0 0 0 1 (the matrix is probably row-major),
  /// - a matrix could move a vertex more than 2^60 units away from the origin, or
  /// - the model has dual quaternion skinning and a matrix A is not rigid: it mirrors, or an
  /// element
  ///   of A^T A - I is more than 2^-10.
  /// If a matrix is invalid, the error names its joint.
  ///
  /// For the check of 2^60 units, a mesh that reaches less than 2^-60 units from the origin counts
  /// as a mesh that reaches this far. A matrix with an element beyond 2^120 in its linear part is
  /// therefore an error for every mesh.
  Result<void> set_palette(std::span<const Matrix4> palette);

  /// Like `set_palette`, with 16 floats per joint in the layout of `Matrix4`.
  Result<void> set_palette(std::span<const float> palette);

  /// Like `set_palette`, with the first three rows of each matrix.
  Result<void> set_palette(std::span<const Matrix3x4> palette);

  /// Like `set_palette`, with 16 doubles per joint in the layout of `Matrix4`. Each element is
  /// rounded once, to the nearest float (ties to even), and the floats are then validated. An
  /// element beyond the range of float becomes infinite and is an error.
  Result<void> set_palette(std::span<const double> palette);

  /// Copies a joint palette of dual quaternions, 8 floats per joint: the rotation as a quaternion
  /// x, y, z, w, then the dual part, which is the product of (t / 2, 0) and the rotation for the
  /// translation t. Both are normalised in double and rounded once. For models with
  /// `Skinning::dual_quaternion`; `set_palette` accepts rigid matrices for them.
  ///
  /// Cost: O(J). Allocates nothing.
  ///
  /// Returns an error and leaves the pose unchanged if
  /// - the model has another kind of skinning,
  /// - the number of floats is not 8 times `model().joint_count()`,
  /// - a float is not finite,
  /// - the squared length of a rotation differs from 1 by more than 2^-10, or
  /// - a vertex could be moved more than 2^60 units away from the origin.
  /// If a dual quaternion is invalid, the error names its joint.
  Result<void> set_dual_quaternions(std::span<const float> dual_quaternions);

  /// Copies the weights of the model's morph targets. Before the joints transform a vertex, the
  /// vertex is displaced by the sum of weight x displacement over all targets. Any finite weight is
  /// allowed.
  ///
  /// Cost: O(M + J). Allocates nothing. In queries, a target with weight 0 costs nothing. Any other
  /// target costs time only in nodes with vertices that it displaces.
  ///
  /// Returns an error and leaves the pose unchanged if
  /// - the number of weights is not `model().morph_target_count()`,
  /// - a weight is not finite,
  /// - the weights could displace a vertex by more than 2^60 units, or
  /// - a joint could move a displaced vertex more than 2^60 units away from the origin.
  /// Except for a wrong number of weights, the error names the target or the joint.
  Result<void> set_morph_weights(std::span<const float> weights);

  /// Allocates all memory that queries can need in this pose. Queries then never allocate in the
  /// pose. Discards all opened nodes, so call `reserve` once, before the first frame. Queries also
  /// allocate in a `Scratch`, which has its own `reserve`.
  ///
  /// Memory: 40 to 46 bytes per triangle, for example 1.1 MB for a character of 26,756 triangles. A
  /// query touches only the memory of the nodes that it opens.
  void reserve();

  /// For internal use.
  detail::Pose& detail() { return *pose_; }
  const detail::Pose& detail() const { return *pose_; }

 private:
  std::unique_ptr<detail::Pose> pose_;
};

/// Writes all posed vertices, bit for bit the float32 positions that queries use. A posed vertex is
/// its rest position plus the weighted displacements of the morph targets, transformed as the
/// model's `Skinning` defines. Queries do not need this function.
///
/// Precondition: `out` has `pose.model().vertex_count()` elements.
///
/// Cost: O(V * influences per vertex). Each morph target with a weight other than 0 adds O(log V)
/// for each vertex that the target displaces. Allocates nothing.
PELT_API void posed_vertices(const Pose& pose, std::span<Vec3> out);

}  // namespace pelt
