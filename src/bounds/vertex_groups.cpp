/// Bounds of groups of vertices.

#include <pelt/bounds.hpp>

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "base/problem.hpp"
#include "bounds/bounds_search.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "model/unpack.hpp"
#include "pose/pose.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pelt::detail {

struct VertexGroups {
  SkinnedModel model;
  std::vector<std::uint32_t> first_place;  // [G + 1], into places
  std::vector<std::uint32_t> places;       // of the groups' vertices in the tree's pools
  NodeBounds bounds;                       // a node for each group

  std::uint32_t count() const { return static_cast<std::uint32_t>(first_place.size() - 1); }
  std::span<const std::uint32_t> places_of(std::uint32_t group) const {
    return std::span(places).subspan(first_place[group],
                                     first_place[group + 1] - first_place[group]);
  }
};

namespace {

/// Sets of vertices, each a list of places in the tree's pools, ascending.
using VertexSets = std::vector<std::vector<std::uint32_t>>;

/// Calls `visit(triangle, place)` for each corner of each triangle. A vertex in several pools has
/// the same place in all triangles.
template <typename Visit>
void each_corner(const Tree& tree, const Visit& visit) {
  const SkinnedMesh mesh = unpack_mesh(tree);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t vertex : mesh.triangles[t]) visit(t, tree.vertex_places[vertex]);
}

std::uint32_t leading_joint(const Tree& tree, std::uint32_t place) {
  const auto weights = tree.weights.begin();
  const auto first = weights + tree.influence_begin[place];
  const auto last = weights + tree.influence_begin[place + 1];
  return tree.joints[static_cast<std::size_t>(std::max_element(first, last) - weights)];
}

void keep_each_once(VertexSets& sets) {
  for (std::vector<std::uint32_t>& places : sets) {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }
}

/// Returns the vertices of the triangles with each label, ignoring kNoGroup. Precondition: `labels`
/// has one element per triangle, each less than `count` or kNoGroup.
VertexSets corners_by_label(const Tree& tree, std::span<const std::uint32_t> labels,
                            std::uint32_t count) {
  VertexSets sets(count);
  each_corner(tree, [&](std::uint32_t triangle, std::uint32_t place) {
    if (labels[triangle] != kNoGroup) sets[labels[triangle]].push_back(place);
  });
  keep_each_once(sets);
  return sets;
}

/// Returns the vertices of all triangles by the joint with their largest weight; of equal weights,
/// the first.
VertexSets corners_by_joint(const Tree& tree) {
  VertexSets sets(tree.joint_count);
  each_corner(tree, [&](std::uint32_t, std::uint32_t place) {
    sets[leading_joint(tree, place)].push_back(place);
  });
  keep_each_once(sets);
  return sets;
}

}  // namespace

}  // namespace pelt::detail

namespace pelt {
namespace {

using detail::Problem;
using detail::require;

VertexGroups make_groups(const SkinnedModel& model, const detail::VertexSets& sets) {
  const detail::Tree& tree = model.detail().tree;
  detail::VertexGroups groups = {model, {0}, {}, {}};
  for (const std::vector<std::uint32_t>& places : sets) {
    groups.places.insert(groups.places.end(), places.begin(), places.end());
    groups.first_place.push_back(static_cast<std::uint32_t>(groups.places.size()));
  }
  groups.bounds = detail::fit_set_bounds(
      tree, sets, detail::invent_sample_poses(detail::unpack_vertices(tree)));
  return VertexGroups(std::make_shared<const detail::VertexGroups>(std::move(groups)));
}

/// Validates labels. Returns an empty Problem if they are valid.
Problem check_labels(std::span<const std::uint32_t> labels, std::uint32_t triangle_count) {
  if (labels.size() != triangle_count)
    return detail::problem("labels has %zu elements, expected one for each of the %u triangles",
                           labels.size(), triangle_count);
  for (std::size_t t = 0; t < labels.size(); ++t)
    if (labels[t] != kNoGroup && labels[t] >= triangle_count)
      return detail::problem(
          "labels[%zu] is %u: number the groups from 0, below the %u "
          "triangles, or use kNoGroup",
          t, labels[t], triangle_count);
  return {};
}

std::uint32_t group_count(std::span<const std::uint32_t> labels) {
  std::uint32_t count = 0;
  for (const std::uint32_t label : labels)
    if (label != kNoGroup) count = std::max(count, label + 1);
  return count;
}

/// Whether the pose belongs to the groups' model.
bool is_pose_of(const Pose& pose, const VertexGroups& groups) {
  return &pose.model().detail() == &groups.model().detail();
}

Box to_box(const detail::BoxFound& found) {
  return {{found.low[0], found.low[1], found.low[2]},
          {found.high[0], found.high[1], found.high[2]}};
}

}  // namespace

VertexGroups::VertexGroups(std::shared_ptr<const detail::VertexGroups> groups)
    : groups_(std::move(groups)) {}

const SkinnedModel& VertexGroups::model() const { return groups_->model; }
std::uint32_t VertexGroups::count() const { return groups_->count(); }

std::uint32_t VertexGroups::vertex_count(std::uint32_t group) const {
  require(group < count(), "vertex_count: no group has that number; see count()");
  return static_cast<std::uint32_t>(groups_->places_of(group).size());
}

std::size_t VertexGroups::memory_bytes() const {
  const detail::NodeBounds& bounds = groups_->bounds;
  return sizeof(detail::VertexGroups) + detail::bytes_held(groups_->first_place) +
         detail::bytes_held(groups_->places) + detail::bytes_held(bounds.nodes) +
         detail::bytes_held(bounds.joints) + detail::bytes_held(bounds.joint_boxes) +
         detail::bytes_held(bounds.shapes) + detail::bytes_held(bounds.fits) +
         detail::bytes_held(bounds.displacement_begin, bounds.displacements) +
         detail::bytes_held(bounds.dual_bounds, bounds.joint_pairs) +
         detail::bytes_held(bounds.offset_caps);
}

Result<VertexGroups> group_triangles(const SkinnedModel& model,
                                     std::span<const std::uint32_t> labels) {
  if (Problem found = check_labels(labels, model.triangle_count()); !found.empty())
    return detail::invalid_argument(std::move(found));
  return make_groups(model,
                     detail::corners_by_label(model.detail().tree, labels, group_count(labels)));
}

VertexGroups group_by_joint(const SkinnedModel& model) {
  return make_groups(model, detail::corners_by_joint(model.detail().tree));
}

QueryStats group_bounds(const Pose& pose, const VertexGroups& groups, std::uint32_t group,
                        Box& result) {
  require(is_pose_of(pose, groups),
          "group_bounds: the groups belong to another model than the pose");
  require(group < groups.count(), "group_bounds: no group has that number; see count()");
  const detail::Pose& data = pose.detail();
  const detail::BoxFound found = data.given
                                     ? box_given(data.given, groups.detail().places_of(group))
                                     : bound_of_set(groups.detail().bounds, group, data.palette);
  result = to_box(found);
  return found.work;
}

QueryStats exact_group_bounds(const Pose& pose, const VertexGroups& groups, std::uint32_t group,
                              Box& result) {
  require(is_pose_of(pose, groups),
          "exact_group_bounds: the groups belong to another model than the pose");
  require(group < groups.count(), "exact_group_bounds: no group has that number; see count()");
  const detail::Pose& data = pose.detail();
  const std::span<const std::uint32_t> places = groups.detail().places_of(group);
  const detail::BoxFound found = data.given
                                     ? box_given(data.given, places)
                                     : box_places(pose.model().detail().tree, data.palette, places);
  result = to_box(found);
  return found.work;
}

}  // namespace pelt
