#pragma once

#include <pelt/config.hpp>

#include <pelt/model.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace pelt {

namespace detail {
struct Pose;
}

/// One instance of a model: a joint palette, weights of morph targets, and the bounds that queries
/// have computed from both so far. To change a pose, call `set_palette` or `set_dual_quaternions`,
/// `set_morph_weights` and `set_offsets`, in any order. No separate refit is necessary: queries
/// compute the bounds that they need.
/// For a mesh that another program deforms, call `set_vertices` instead.
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
  /// - the model has dual quaternion skinning, and a matrix A is not rigid: it mirrors, or an
  ///   element of A^T A - I is more than 2^-10.
  /// If a matrix is invalid, the error names its joint.
  ///
  /// An element beyond 2^120 in the linear part of a matrix is an error for every mesh, however
  /// small, and so is a double beyond the range of float.
  Result<void> set_palette(const JointMatrices& palette);

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

  /// Copies the positions of all vertices, in the frame shared by all poses of a query, and
  /// computes the boxes of all nodes from them. All queries then answer as if joints had posed the
  /// vertices to these positions. Use this for cloth caches, simulated bodies, body models with
  /// correctives, and other surfaces that are not a linear blend of joints.
  ///
  /// `set_palette`, `set_morph_weights` and `set_offsets` end this: the vertices are then posed by
  /// the joints again, with the last palette, morph weights and offsets that were set.
  ///
  /// `vertices`: [V] in the order of `SkinnedMeshView::rest_positions`.
  ///
  /// Cost: O(V). Queries then cost less than after `set_palette`, because boxes are tighter and
  /// nothing is skinned. Allocates if the pose has less memory than `reserve` would allocate.
  ///
  /// Returns an error and leaves the pose unchanged if
  /// - the number of vertices is not `model().vertex_count()`,
  /// - a coordinate is NaN or its magnitude is more than 2^60, or
  /// - two vertices differ that the model has merged (see `ModelOptions::weld`).
  /// Except for a wrong number, the error names the vertex.
  Result<void> set_vertices(std::span<const Vec3> vertices);

  /// Borrows an offset for each vertex, which is added to the vertex after the joints have posed
  /// it, in the frame shared by all poses of a query. Use this for cloth near a body and for other
  /// details with a known largest size. Each coordinate is clamped to the cap of the vertex (see
  /// `SkinnedMeshView::offset_caps`), and NaN counts as 0, so a posed vertex is defined for every
  /// offset, and boxes that are widened by the caps enclose it. `QueryStats::clamped_offsets` and
  /// `check_offsets` count what was clamped, because a renderer would not clamp it.
  ///
  /// `offsets`: [V], or empty to remove the offsets.
  ///
  /// Precondition: the elements live, and do not change, until the next `set_offsets` of the pose,
  /// or until the last query of the pose. To change them, call `set_offsets` again.
  ///
  /// Cost: O(1). Queries add the offsets of the nodes that they open. Allocates nothing.
  ///
  /// Returns an error and leaves the pose unchanged if the number of offsets is neither 0 nor
  /// `model().vertex_count()`, or if the model has no caps.
  Result<void> set_offsets(std::span<const Vec3> offsets);

  /// Allocates all memory that queries and `set_vertices` can need in this pose. They then never
  /// allocate in the pose. Discards all opened nodes, so call `reserve` once, before the first
  /// frame. Queries also allocate in a `Scratch`, which has its own `reserve`.
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
/// model's `Skinning` defines, plus its clamped offset; or the vertex given to
/// `Pose::set_vertices`. Queries do not need this function.
///
/// Precondition: `out` has `pose.model().vertex_count()` elements.
///
/// Cost: O(V * influences per vertex). Each morph target with a weight other than 0 adds O(log V)
/// for each vertex that the target displaces. Allocates nothing.
PELT_API void posed_vertices(const Pose& pose, std::span<Vec3> out);

/// Returns the number of vertices whose offset is clamped: with a coordinate that is NaN or beyond
/// the cap. 0 if the pose has no offsets.
///
/// Cost: O(V). Allocates nothing.
PELT_API std::uint32_t check_offsets(const Pose& pose);

/// Checks that the bounds of a pose enclose its posed vertices (see `posed_vertices`), for use in
/// tests. First checks the bounds that earlier queries have stored in `pose`, and then all bounds
/// that a query could compute. Leaves `pose` unchanged.
///
/// Returns an empty string if every bound encloses its vertices. Otherwise returns a message about
/// the first violation, with the node, the bound, and how far a vertex is outside the bound. A
/// violation is a bug in Pelt.
///
/// Cost: O(T + V). Allocates.
PELT_API std::string check_bounds(const Pose& pose);

}  // namespace pelt
