#pragma once

/// Bounds of parts of a posed skin: of a file's parts, of materials, of what each joint moves.

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
struct Groups;
}

/// The label of a triangle that belongs to no group.
inline constexpr std::uint32_t kNoGroup = 0xFFFFFFFF;

/// Sets of a model's vertices with what their bounds need. Immutable, cheap to copy (copies share),
/// safe to use from any number of threads. The model does not know of it.
class PELT_API Groups {
 public:
  /// The model that it was made of.
  const SkinnedModel& model() const;

  /// G, empty groups included.
  std::uint32_t count() const;

  /// Different posed vertices of a group. Precondition: group < G.
  std::uint32_t vertex_count(std::uint32_t group) const;

  /// What it takes in memory, without the model.
  std::size_t memory_bytes() const;

  /// For Pelt's own files.
  explicit Groups(std::shared_ptr<const detail::Groups> groups);
  const detail::Groups& detail() const { return *groups_; }

 private:
  std::shared_ptr<const detail::Groups> groups_;
};

/// Groups of triangles: `labels` [T] says for each triangle in which group it is, or kNoGroup.
/// There are as many groups as the largest label says. A group's vertices are its triangles'
/// corners.
///
/// Refuses labels that are not one for each triangle, or one that is no less than T. O(V log V);
/// allocates.
PELT_API Result<Groups> group_triangles(const SkinnedModel& model,
                                        std::span<const std::uint32_t> labels);

/// A group for each joint, in the order of the palette: the vertices that triangles use and that
/// follow the joint with their largest weight (of equals the first joint's). Groups of joints that
/// lead no vertex are empty. O(V log V); allocates.
PELT_API Groups group_by_joint(const SkinnedModel& model);

/// Writes a box that surely encloses the posed vertices of one group, from the joint palette alone.
/// An empty group has the box from infinity to minus infinity. O(joints of the group).
///
/// Precondition: `pose` is of the groups' model, group < G; otherwise the program aborts, in every
/// build.
PELT_API QueryStats group_bounds(const Pose& pose, const Groups& groups, std::uint32_t group,
                                 Box& result);

/// Writes the exact box of the posed vertices of one group, but that zeros are positive. O(vertices
/// of the group times influences), and O(log V) for each vertex and active target that displaces
/// it. Precondition and empty groups as above.
PELT_API QueryStats exact_group_bounds(const Pose& pose, const Groups& groups, std::uint32_t group,
                                       Box& result);

}  // namespace pelt
