/// The queries for the least distance, of two poses and of points.

#include <pelt/distance.hpp>

#include "base/assert.hpp"
#include "collide/collide_trees.hpp"
#include "distance/answers.hpp"
#include "distance/distance_search.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "query/valid_numbers.hpp"

#include <cmath>

namespace pelt {
namespace {

using detail::PosedTree;
using detail::require;
using detail::surface_point;

Distance touching(const PosedTree& a, const PosedTree& b, const Contact& contact,
                  QueryStats& work) {
  const detail::FoundTriangle found_a = detail::find_triangle(a, contact.triangle_a, work);
  const detail::FoundTriangle found_b = detail::find_triangle(b, contact.triangle_b, work);
  Distance closest = detail::distance_touching(contact, found_a.corners, found_b.corners);
  closest.location =
      detail::Access::location<4>({found_a.node, found_a.slot, found_b.node, found_b.slot});
  return closest;
}

/// Writes the touching pairs to `scratch.found`, the first step of both queries.
QueryStats find_touching(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return detail::collide_trees(a, b, scratch.detail(), max_contacts);
}

/// Writes the pairs to `scratch.found`, in no particular order.
QueryStats find_within(Pose& a, Pose& b, double tolerance, Scratch& scratch,
                       std::uint32_t max_pairs) {
  const PosedTree tree_a = a.detail().posed_tree(), tree_b = b.detail().posed_tree();
  QueryStats stats = find_touching(tree_a, tree_b, scratch, max_pairs);
  if (tolerance > 0 && scratch.detail().found.size() < max_pairs)
    stats += detail::triangles_within(tree_a, tree_b, scratch.detail(), tolerance, max_pairs);
  return stats;
}

}  // namespace

QueryStats closest_point(Pose& pose, const Vec3& point, Scratch& scratch, ClosestPoint& result,
                         const Limits& limits) {
  require(limits.max_distance >= 0, "closest_point: the maximum distance is negative or NaN");
  require(detail::is_finite(point), "closest_point: the point is NaN or infinite");
  detail::PointGap gap;
  const QueryStats stats = detail::closest_to_point(pose.detail().posed_tree(), point,
                                                    scratch.detail(), limits.max_distance, gap);
  result.distance = std::sqrt(gap.closest.squared_distance);
  result.point = surface_point(gap.triangle, gap.corners, gap.closest.at);
  return stats;
}

QueryStats closest_points(Pose& pose, std::span<const Vec3> points, Scratch& scratch,
                          std::span<ClosestPoint> results, const Limits& limits) {
  require(points.size() == results.size(), "closest_points: give one result for each point");
  QueryStats stats;
  for (std::size_t i = 0; i < points.size(); ++i)
    stats += closest_point(pose, points[i], scratch, results[i], limits);
  return stats;
}

QueryStats distance(Pose& a, Pose& b, Scratch& scratch, Distance& result,
                    const DistanceOptions& options) {
  require(&a != &b, "distance: `a` and `b` are the same pose; give two poses");
  const PosedTree tree_a = a.detail().posed_tree(), tree_b = b.detail().posed_tree();
  return detail::least_distance(
      scratch.detail(), options, result,
      [&](std::uint32_t most, std::uint64_t max_work) {
        return max_work == detail::SearchLimits::kUnlimited
                   ? find_touching(tree_a, tree_b, scratch, most)
                   : detail::collide_trees_within(tree_a, tree_b, scratch.detail(), most, max_work);
      },
      [&](const Contact& contact, QueryStats& work) {
        return touching(tree_a, tree_b, contact, work);
      },
      [&](const detail::SearchLimits& limits, detail::TriangleGap& gap) {
        return detail::closest_triangles(tree_a, tree_b, scratch.detail(), limits, gap);
      });
}

QueryStats clearance(Pose& a, Pose& b, double tolerance, Scratch& scratch,
                     std::vector<Contact>& pairs, const Limits& limits) {
  require(&a != &b, "clearance: `a` and `b` are the same pose; give two poses");
  require(tolerance >= 0, "clearance: the tolerance is negative or NaN");
  const std::uint32_t most = limits.max_contacts;
  QueryStats stats = find_within(a, b, tolerance, scratch, most == UINT32_MAX ? most : most + 1);
  detail::Stack<Contact>& found = scratch.detail().found;
  stats.cut_short = found.size() > most;
  found.shrink(most);
  detail::sort_contacts(found, scratch.detail().sorting);
  std::size_t end = pairs.size();
  pairs.resize(end + found.size());
  for (const Contact& pair : found) pairs[end++] = {pair.triangle_a, pair.triangle_b};
  return stats;
}

YesNo is_within(Pose& a, Pose& b, double tolerance, Scratch& scratch) {
  require(&a != &b, "is_within: `a` and `b` are the same pose; give two poses");
  require(tolerance >= 0, "is_within: the tolerance is negative or NaN");
  const QueryStats stats = find_within(a, b, tolerance, scratch, 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

}  // namespace pelt
