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

/// One instance of a model in one posture: a joint palette, the weights of morph targets, and the
/// bounds that queries have derived from both so far. There is nothing to update or refit by hand:
/// the whole update is `set_palette` and `set_morph_weights`, in any order, and a query refits what
/// it visits.
///
/// A new pose has identity matrices and morph weights of zero, that is, the rest positions. Queries
/// write the bounds that they refit into the pose, so one thread at a time may query a pose.
/// Movable, not copyable; one that has been moved from may only be assigned to or destroyed.
class PELT_API Pose {
 public:
  /// Allocates the joint palette, O(J). Queries allocate when they open more than in any frame
  /// before; `reserve` forestalls that.
  explicit Pose(SkinnedModel model);
  Pose(Pose&&) noexcept;
  Pose& operator=(Pose&&) noexcept;
  ~Pose();

  const SkinnedModel& model() const;

  /// Takes the joint palette: matrix j maps the rest positions that joint j moves into the frame
  /// shared by all poses of a query (`instance x joint x inverse bind`). Copies it; O(J), no
  /// allocation.
  ///
  /// Refuses, and leaves the pose as it was, when there are not `model().joint_count()` matrices,
  /// an element is not finite, a last row is not 0 0 0 1 (a row-major matrix, most likely), or a
  /// vertex could land beyond 2^60 units (a mesh within 2^-60 units of the origin counts as that
  /// large). The message names the joint.
  Result<void> set_palette(std::span<const Matrix4> palette);

  /// The same from 16 floats a joint, in the layout of `Matrix4`.
  Result<void> set_palette(std::span<const float> palette);

  /// The same from the first three rows of each matrix.
  Result<void> set_palette(std::span<const Matrix3x4> palette);

  /// The same from 16 doubles a joint, in the layout of `Matrix4`. Each element is rounded once, to
  /// the nearest float (of two equally near ones the even one), and the floats are then validated:
  /// an element beyond the range of float becomes infinite and is refused.
  Result<void> set_palette(std::span<const double> palette);

  /// Takes the weights of the model's morph targets: a vertex is displaced by the sum of weight x
  /// displacement before the joints move it. Any finite number is allowed; what has the weight 0
  /// costs nothing in queries, and of the others each costs something only in the nodes whose
  /// vertices it displaces. Copies them; O(M + J), no allocation.
  ///
  /// Refuses, and leaves the pose as it was, when there are not `model().morph_target_count()`
  /// weights, one is not finite, or a vertex could be displaced by, or land beyond, 2^60 units. The
  /// message names the target or joint.
  Result<void> set_morph_weights(std::span<const float> weights);

  /// Takes at once all the memory that queries could ever want of this pose: none then allocates
  /// for it, whatever it visits. For those who must not allocate within a frame, once and before
  /// the first; the scratch has a `reserve` of its own.
  ///
  /// The pose holds 40 to 46 bytes a triangle from then on (1.1 MB for a character of 26,756), of
  /// which a query touches what it opens. What has been opened in the current palette is forgotten.
  void reserve();

  /// For Pelt's own files.
  detail::Pose& detail() { return *pose_; }
  const detail::Pose& detail() const { return *pose_; }

 private:
  std::unique_ptr<detail::Pose> pose_;
};

/// Writes every posed vertex: the very float32 positions that queries collide, linear blend
/// skinning of the rest positions (Kavan & Zara 2005, eq. 1), to which the displacements of morph
/// targets have been added by weight. Precondition: `out` has `vertex_count()` elements. O(V times
/// influences) and, where active targets displace vertices, O(log V) for each of these and target;
/// allocates nothing, and is not needed for any query.
PELT_API void posed_vertices(const Pose& pose, std::span<Vec3> out);

}  // namespace pelt
