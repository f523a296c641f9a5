#include <pelt/distance.hpp>

#include "base/assert.hpp"
#include "collide/pair_traversal.hpp"
#include "distance/answers.hpp"
#include "distance/pair_search.hpp"
#include "distance/point_search.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace pelt {
namespace {

using detail::PosedTree;
using detail::surface_point;

/// Returns the lowest touching pair.
Distance touching(const PosedTree& a, const PosedTree& b, const Contact& contact,
                  QueryStats& work) {
  const detail::FoundTriangle found_a = detail::find_triangle(a, contact.triangle_a, work);
  const detail::FoundTriangle found_b = detail::find_triangle(b, contact.triangle_b, work);
  const detail::NearestPoints common = detail::common_point(found_a.corners, found_b.corners);
  Distance nearest;
  nearest.distance = 0;
  nearest.a = surface_point(contact.triangle_a, found_a.corners, common.a);
  nearest.b = surface_point(contact.triangle_b, found_b.corners, common.b);
  nearest.places = {found_a.node, found_a.slot, found_b.node, found_b.slot};
  return nearest;
}

/// Writes the touching pairs to `scratch.found`, the first step of both queries.
QueryStats find_touching(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return detail::collide_trees(a, b, scratch.detail(), max_contacts);
}

/// Writes the pairs to `scratch.found`, in no particular order.
QueryStats find_within(Pose& a, Pose& b, double tolerance, Scratch& scratch,
                       std::uint32_t max_contacts) {
  PELT_ASSERT(&a != &b);
  PELT_ASSERT(tolerance >= 0);
  const PosedTree tree_a = a.detail().posed_tree(), tree_b = b.detail().posed_tree();
  QueryStats stats = find_touching(tree_a, tree_b, scratch, max_contacts);
  if (tolerance > 0 && scratch.detail().found.size() < max_contacts)
    stats += detail::triangles_within(tree_a, tree_b, scratch.detail(), tolerance, max_contacts);
  return stats;
}

}  // namespace

QueryStats closest_point(Pose& pose, const Vec3& point, Scratch& scratch, ClosestPoint& closest,
                         const ClosestPointOptions& options) {
  PELT_ASSERT(options.max_distance >= 0);
  detail::PointGap gap;
  const QueryStats stats = detail::nearest_to_point(pose.detail().posed_tree(), point,
                                                    scratch.detail(), options.max_distance, gap);
  closest.distance = std::sqrt(gap.nearest.squared_distance);
  closest.point = surface_point(gap.triangle, gap.corners, gap.nearest.at);
  return stats;
}

QueryStats closest_points(Pose& pose, std::span<const Vec3> points, Scratch& scratch,
                          std::span<ClosestPoint> closest, const ClosestPointOptions& options) {
  PELT_ASSERT(points.size() == closest.size());
  QueryStats stats;
  for (std::size_t i = 0; i < points.size(); ++i)
    stats += closest_point(pose, points[i], scratch, closest[i], options);
  return stats;
}

QueryStats distance(Pose& a, Pose& b, Scratch& scratch, Distance& nearest,
                    const DistanceOptions& options) {
  PELT_ASSERT(&a != &b);
  PELT_ASSERT(options.max_distance >= 0 && options.tolerance >= 0);
  const PosedTree tree_a = a.detail().posed_tree(), tree_b = b.detail().posed_tree();
  const std::uint32_t wanted = options.tolerance > 0 ? 1 : CollideOptions().max_contacts;
  QueryStats stats = find_touching(tree_a, tree_b, scratch, wanted);
  stats.cut_short = false;
  const detail::Places hint = options.hint ? options.hint->places : detail::Places{};
  if (detail::Stack<Contact>& found = scratch.detail().found; !found.empty()) {
    nearest = touching(tree_a, tree_b, *std::min_element(found.begin(), found.end()), stats);
    return stats;
  }
  detail::TriangleGap gap;
  const detail::SearchLimits limits = {options.max_distance, options.tolerance,
                                       options.hint ? &hint : nullptr};
  stats += detail::nearest_triangles(tree_a, tree_b, scratch.detail(), limits, gap);
  nearest = detail::distance_apart(gap, options);
  return stats;
}

QueryStats clearance(Pose& a, Pose& b, double tolerance, Scratch& scratch,
                     std::vector<Contact>& contacts, const ClearanceOptions& options) {
  const std::uint32_t most = options.max_contacts;
  QueryStats stats = find_within(a, b, tolerance, scratch, most == UINT32_MAX ? most : most + 1);
  stats.cut_short = scratch.detail().found.size() > most;
  scratch.detail().found.shrink(most);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

bool is_within(Pose& a, Pose& b, double tolerance, Scratch& scratch) {
  find_within(a, b, tolerance, scratch, 1);
  return !scratch.detail().found.empty();
}

}  // namespace pelt
