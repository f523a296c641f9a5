#pragma once

/// Finds a place near the closest one: the cluster whose box is closest to a point. Tests no
/// triangles, and opens only nodes whose boxes are nearer than the best cluster so far.

#include "pose/open_node.hpp"
#include "query/push_nearest_last.hpp"
#include "query/scratch.hpp"
#include "query/squared_gaps.hpp"
#include "query/tree_part.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Precondition: there is a table of opened nodes.
inline TreePart closest_cluster(const PosedTree& posed, const Vec3& point, Stack<NearPart>& parts,
                                QueryStats& work) {
  const Box8 box = {{Float8(point.x), Float8(point.y), Float8(point.z)},
                    {Float8(point.x), Float8(point.y), Float8(point.z)}};
  NearPart closest = {HUGE_VALF, 0, TreePart::kWhole};
  parts.clear();
  parts.push({0, 0, TreePart::kWhole});
  while (!parts.empty()) {
    const NearPart near = parts.pop();
    if (!(near.squared_gap < closest.squared_gap)) continue;
    const TreePart part = {near.node, near.slot};
    if (is_cluster(posed, part)) {
      closest = near;
      continue;
    }
    ++work.node_pairs;
    const std::uint32_t node = node_of(posed, part);
    const OpenedNode& opened = open_node(posed, node, work);
    const Float8 gaps = squared_gaps(opened.low, opened.high, 0, box);
    const unsigned nearer = (gaps < Float8(closest.squared_gap)).bits();
    push_nearest_last(parts, nearer & slots_of(posed.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearPart{gap, node, slot};
                      });
  }
  return {closest.node, closest.slot};
}

/// Returns the point of a cluster's box that is closest to a given point.
inline Vec3 closest_of_box(const PosedTree& posed, const TreePart& cluster, const Vec3& point) {
  const OpenedNode& opened = *posed.opened[cluster.node];
  const auto closest = [&](int axis, float x) {
    const float low = opened.low[axis][cluster.slot], high = opened.high[axis][cluster.slot];
    return x < low ? low : x > high ? high : x;
  };
  return {closest(0, point.x), closest(1, point.y), closest(2, point.z)};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
