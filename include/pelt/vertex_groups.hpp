#pragma once

/// Boxes of subsets of a posed skin: of the parts of a file, of materials, or of the vertices that
/// follow one joint more than any other.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>
#include <pelt/shapes.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace pelt {

namespace detail {
struct VertexGroups;
}

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

}  // namespace pelt
