/// A vertex is worth a look only if it is further from the surface than the deepest one so far, so
/// the nearest point is asked for first, within that depth, and whether the vertex is inside only
/// where nothing was found.

#include <pelt/inside.hpp>

#include "base/assert.hpp"
#include "base/wide_code.hpp"
#include "contact/surface.hpp"
#include "model/model.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace pelt {
namespace {

using detail::Cluster;
using detail::Node;
using detail::OpenedNode;
using detail::PosedTree;
using detail::RootBox;

/// Whether a slot's box meets the other body's.
bool meets(const OpenedNode& opened, std::uint32_t slot, const RootBox& box) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (opened.high[axis][slot] < box.low[axis] || box.high[axis] < opened.low[axis][slot])
      return false;
  return true;
}

class DeepestVertex {
 public:
  DeepestVertex(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                Scratch& scratch)
      : a_(a.detail().posed_tree()),
        surface_a_(surface_a.detail()),
        b_(b),
        surface_b_(surface_b),
        scratch_(scratch),
        box_b_(detail::wide_code().root_box(b.detail().posed_tree(), work_)) {}

  QueryStats run(Penetration& deepest) {
    make_table(a_);
    detail::Stack<std::uint32_t>& nodes = scratch_.detail().nodes;
    nodes.clear();
    nodes.push(0);
    while (!nodes.empty()) visit(nodes.pop(), nodes);
    deepest = deepest_;
    return work_;
  }

 private:
  void visit(std::uint32_t index, detail::Stack<std::uint32_t>& nodes) {
    ++work_.node_pairs;
    const Node& node = a_.tree.nodes[index];
    const OpenedNode& opened = detail::wide_code().open_node(a_, index, work_);
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot)
      if (meets(opened, slot, box_b_)) visit(a_.tree.clusters[node.first_cluster + slot], opened);
    for (std::uint32_t child = 0; child < node.child_count; ++child)
      if (meets(opened, node.cluster_count + child, box_b_)) nodes.push(node.first_child + child);
  }

  /// Its vertices, each once.
  void visit(const Cluster& cluster, const OpenedNode& opened) {
    std::array<std::uint16_t, 3 * detail::kMaxClusterTriangles> seen;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
      const std::uint32_t place = cluster.first_triangle + i;
      const Triangle& vertices = surface_a_.corners[a_.tree.triangle_ids[place]];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint16_t offset = a_.tree.corners[place][corner];
        if (std::find(seen.begin(), seen.begin() + count, offset) != seen.begin() + count) continue;
        seen[count++] = offset;
        const float* at = opened.positions + offset;
        consider(vertices[corner], {at[0], at[1], at[2]});
      }
    }
  }

  void consider(std::uint32_t vertex, const Vec3& position) {
    const double depth = deepest_.depth;
    ClosestPoint closest;
    if (deepest_.found()) {
      work_ += closest_point(b_, position, scratch_, closest, {depth});
      if (closest.found() && (closest.distance < depth || vertex >= deepest_.vertex)) return;
    }
    if (side_of(b_, surface_b_, position, scratch_) != PointSide::inside) return;
    if (!closest.found()) work_ += closest_point(b_, position, scratch_, closest);
    deepest_ = {vertex, position, closest.point, closest.distance};
  }

  const PosedTree a_;
  const detail::Surface& surface_a_;
  Pose& b_;
  const Surface& surface_b_;
  Scratch& scratch_;
  QueryStats work_;
  const RootBox box_b_;
  Penetration deepest_;
};

}  // namespace

QueryStats deepest_vertex(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                          Scratch& scratch, Penetration& deepest) {
  PELT_ASSERT(&a != &b);
  PELT_ASSERT(&a.model().detail() == &surface_a.model().detail());
  PELT_ASSERT(surface_b.is_closed());
  return DeepestVertex(a, surface_a, b, surface_b, scratch).run(deepest);
}

}  // namespace pelt
