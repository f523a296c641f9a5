#pragma once

/// Finds a place near the nearest one: the cluster whose box is nearest to a point. Tests no
/// triangles, and opens only nodes whose boxes are nearer than the best cluster so far.

#include "pose/open_node.hpp"
#include "query/push_nearest_last.hpp"
#include "query/scratch.hpp"
#include "query/squared_gaps.hpp"
#include "query/tree_part.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Precondition: there is a table of opened nodes.
inline TreePart nearest_cluster(const PosedTree& posed, const Vec3& point, Stack<NearPart>& parts,
                                QueryStats& work) {
  const Box8 box = {{Float8(point.x), Float8(point.y), Float8(point.z)},
                    {Float8(point.x), Float8(point.y), Float8(point.z)}};
  NearPart nearest = {HUGE_VALF, 0, TreePart::kWhole};
  parts.clear();
  parts.push({0, 0, TreePart::kWhole});
  while (!parts.empty()) {
    const NearPart near = parts.pop();
    if (!(near.squared_gap < nearest.squared_gap)) continue;
    const TreePart part = {near.node, near.slot};
    if (is_cluster(posed, part)) {
      nearest = near;
      continue;
    }
    ++work.node_pairs;
    const std::uint32_t node = node_of(posed, part);
    const OpenedNode& opened = open_node(posed, node, work);
    const Float8 gaps = squared_gaps(opened.low, opened.high, 0, box);
    const unsigned nearer = (gaps < Float8(nearest.squared_gap)).bits();
    push_nearest_last(parts, nearer & slots_of(posed.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearPart{gap, node, slot};
                      });
  }
  return {nearest.node, nearest.slot};
}

/// Returns the point of a cluster's box that is nearest to a given point.
inline Vec3 nearest_of_box(const PosedTree& posed, const TreePart& cluster, const Vec3& point) {
  const OpenedNode& opened = *posed.opened[cluster.node];
  const auto nearest = [&](int axis, float x) {
    const float low = opened.low[axis][cluster.slot], high = opened.high[axis][cluster.slot];
    return x < low ? low : x > high ? high : x;
  };
  return {nearest(0, point.x), nearest(1, point.y), nearest(2, point.z)};
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
