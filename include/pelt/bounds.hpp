#pragma once

/// Boxes and spheres around a posed skin or a part of it, mostly without posing vertices, and the
/// vertex that is farthest in a direction. For culling, shadows, levels of detail and exports.

#include <pelt/config.hpp>

#include <pelt/math.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

namespace pelt {

namespace detail {
struct VertexGroups;
}

/// Bounds of the posed surface, that is, of all triangles. Vertices without triangles do not count.
struct Bounds {
  Box box;
  Sphere sphere;  ///< has the same centre as `box`
};

/// Writes a box and a sphere in the frame of the joint palette. Both are guaranteed to enclose the
/// posed surface. The guarantee includes rounding: box and sphere contain the float32 posed
/// vertices (see `posed_vertices`) of all triangles.
///
/// `levels`: number of tree levels to open, where opening can still extend the box found so far.
///   With 0, box and sphere are computed from the joint palette and the morph weights, without
///   posing vertices. The box is exact if `levels` is at least the depth of the tree.
///
/// Cost: O(J) with `levels` 0, about two and a half times as much as `set_palette`. Each morph
/// weight other than 0 adds at most O(J). With `levels` 0, no node is opened. Each additional level
/// opens a few more nodes. Allocates only in the pose, for nodes that are opened.
///
/// Accuracy: for a human in motion, the box with `levels` 0 is a few per cent to 25 % larger than
/// the exact box. With `levels` 3, it is less than 10 % larger.
///
/// Source: with `levels` 0, eq. 2 of Kavan & Zara 2005, applied to one box per joint. For each
/// joint, the model stores a box around the rest positions that the joint moves. The joint palette
/// transforms these boxes, and the result encloses all of them. If the weights of each joint are
/// nearly an affine function of the rest position, `bounds` may compute a tighter box in another
/// way.
PELT_API QueryStats bounds(Pose& pose, Bounds& result, std::uint32_t levels = 0);

/// Writes the exact box of the posed surface, and a sphere that is guaranteed to enclose the posed
/// surface. The box has the smallest and largest coordinates of all posed vertices of triangles
/// (see `posed_vertices`), bit for bit, except that -0 becomes +0.
///
/// Cost: opens only nodes that may reach beyond the box found so far. Allocates only in the pose,
/// for nodes that are opened.
PELT_API QueryStats exact_bounds(Pose& pose, Bounds& result);

/// Label of a triangle that belongs to no group.
inline constexpr std::uint32_t kNoGroup = 0xFFFFFFFF;

/// Sets of a model's vertices, prepared for computing their bounds. Immutable, cheap to copy
/// (copies share the data), safe to use from any number of threads. One model can have several
/// VertexGroups.
class PELT_API VertexGroups {
 public:
  /// The model of the groups.
  const SkinnedModel& model() const;

  /// Number of groups G, including empty groups.
  std::uint32_t count() const;

  /// Number of vertices of a group. Vertices with the same bits in rest position, influences and
  /// displacements count as one.
  ///
  /// Precondition: group < G. Otherwise the program aborts, in every build.
  std::uint32_t vertex_count(std::uint32_t group) const;

  /// Bytes of memory, without the model.
  std::size_t memory_bytes() const;

  /// For internal use.
  explicit VertexGroups(std::shared_ptr<const detail::VertexGroups> groups);
  const detail::VertexGroups& detail() const { return *groups_; }

 private:
  std::shared_ptr<const detail::VertexGroups> groups_;
};

/// Groups triangles by label. The vertices of a group are those of its triangles. The number of
/// groups is the largest label plus one.
///
/// `labels`: [T] group of each triangle, or kNoGroup.
///
/// Cost: O(V log V). Allocates.
///
/// Returns an error if there is not one label per triangle, or if a label other than kNoGroup is T
/// or more.
PELT_API Result<VertexGroups> group_triangles(const SkinnedModel& model,
                                              std::span<const std::uint32_t> labels);

/// Creates one group per joint, in the order of the palette. A vertex that triangles use is in the
/// group of the joint whose weight is the largest for this vertex. If several joints have this
/// weight, the joint with the lowest index is chosen. Joints without vertices have empty groups.
///
/// Cost: O(V log V). Allocates.
PELT_API VertexGroups group_by_joint(const SkinnedModel& model);

/// Writes a box that is guaranteed to enclose the posed vertices of one group. The box is computed
/// from the joint palette and the morph weights, without posing vertices. For an empty group, `low`
/// is infinity and `high` is minus infinity.
///
/// Precondition: `pose` is a pose of the groups' model, and group < G. Otherwise the program
/// aborts, in every build.
///
/// Cost: O(number of joints that move the vertices of the group). Each morph weight other than 0
/// adds at most the same again. Allocates nothing.
PELT_API QueryStats group_bounds(const Pose& pose, const VertexGroups& groups, std::uint32_t group,
                                 Box& result);

/// Writes the exact box of one group: bit for bit the smallest and largest coordinates of its posed
/// vertices, except that -0 becomes +0. For an empty group, `low` is infinity and `high` is minus
/// infinity.
///
/// Precondition: as for `group_bounds`.
///
/// Cost: O(vertices of the group * influences per vertex). Each morph target with a weight other
/// than 0 adds O(log V) for each vertex of the group that the target displaces. Allocates nothing.
PELT_API QueryStats exact_group_bounds(const Pose& pose, const VertexGroups& groups,
                                       std::uint32_t group, Box& result);

/// Result of `farthest_vertex`. Identifies the vertex by a triangle and one of its corners.
struct FarthestVertex {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::uint32_t triangle = kNone;  ///< index into the model's triangle array
  std::uint32_t corner = 0;        ///< 0, 1 or 2: which corner of that triangle
  Vec3 position;                   ///< posed

  /// Whether a query has written this result.
  explicit operator bool() const { return triangle != kNone; }
};

/// Writes the posed vertex p with the greatest dot(direction, p), among all vertices that triangles
/// use. Dot products are compared exactly. If several corners of triangles have the greatest dot
/// product, writes the lowest corner of the lowest of these triangles.
///
/// `direction`: in the frame of the joint palette, of any length.
///
/// Precondition: `direction` is finite and not zero. Otherwise the program aborts, in every build.
///
/// Cost: opens only nodes whose boxes reach beyond the farthest vertex so far. In each node, the
/// box that reaches farthest is visited first. The query often opens only one node per level of the
/// tree. Allocates only in the pose, for nodes that are opened.
PELT_API QueryStats farthest_vertex(Pose& pose, const Vec3& direction, FarthestVertex& result);

}  // namespace pelt
