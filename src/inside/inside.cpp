/// A point is on the surface if it is in the convex hull of the three posed vertices of some
/// triangle, which may be a triangle, a segment or a point. For any other point, the surface has a
/// definite winding number, and the point is inside if this number is not zero.
///
/// The winding number is the sum of the signs with which a ray from the point pierces triangles, if
/// the ray meets no edge and no collapsed triangle. (The posed surface is a closed cycle, because
/// its edges cancel in pairs. Its degree around the point is the number of signed preimages of any
/// direction whose preimages are all inside triangles that have not collapsed.) The ray of
/// geometry/generic_ray.hpp meets neither: edges and collapsed triangles are in finitely many
/// planes or lines through the point, which the ray avoids. A collapsed triangle contributes
/// nothing, because it is in such a plane, and no triangle whose plane contains the point is
/// pierced. A single ray therefore decides, exact signs decide every triangle that it may pierce,
/// and no second attempt is needed.
///
/// If no triangle of the other body touches the box of a cluster or node, all of its vertices are
/// on one side, and those outside are skipped at once.
///
/// A vertex matters only if it is farther from the surface than the deepest vertex so far. The
/// closest point within that depth is therefore searched first, and the side of the vertex is
/// computed only if nothing was found.

#include <pelt/inside.hpp>
#include <pelt/solid.hpp>

#include "base/assert.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/valid_numbers.hpp"
#include "ray/ray_descent.hpp"

#include <algorithm>
#include <array>

namespace pelt {
namespace {

/// Where a point is with respect to a surface.
struct Location {
  bool is_on = false;
  int winding = 0;  // 0 on the surface
};

QueryStats locate(Pose& pose, const Vec3& point, Scratch& scratch, Location& result) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  QueryStats work;
  work.node_pairs = 1;
  result = {};
  if (!contains(detail::root_box(posed, work), point)) return work;
  const YesNo is_on = intersects(pose, Box{point, point}, scratch);
  work += is_on;
  result.is_on = static_cast<bool>(is_on);
  if (!is_on)
    work += detail::winding_number(posed, point, detail::kGenericDirection, result.winding);
  return work;
}

}  // namespace

QueryStats side_of(Pose& pose, const Vec3& point, Scratch& scratch, PointSide& result) {
  detail::require(detail::surface_of(pose).is_closed, "side_of: the surface is not closed");
  detail::require(detail::is_finite(point), "side_of: the point is NaN or infinite");
  Location location;
  const QueryStats work = locate(pose, point, scratch, location);
  result = location.is_on          ? PointSide::on
           : location.winding != 0 ? PointSide::inside
                                   : PointSide::outside;
  return work;
}

QueryStats winding_number(Pose& pose, const Vec3& point, Scratch& scratch, std::int32_t& result) {
  detail::require(detail::surface_of(pose).is_closed, "winding_number: the surface is not closed");
  detail::require(detail::is_finite(point), "winding_number: the point is NaN or infinite");
  Location location;
  const QueryStats work = locate(pose, point, scratch, location);
  result = location.winding;
  return work;
}

namespace {

/// Whether all components of `inner` are inside `outer`. If the surfaces do not touch, all points
/// of a component are on the same side.
bool holds(Pose& outer, Pose& inner, Scratch& scratch, QueryStats& work) {
  if (!detail::surface_of(outer).is_closed) return false;
  detail::TriangleReader triangles(inner.detail().posed_tree());
  for (const std::uint32_t triangle : detail::surface_of(inner).components) {
    const Vec3 corner = triangles.corners(triangle, work)[0];
    PointSide side = PointSide::outside;
    work += side_of(outer, corner, scratch, side);
    if (side != PointSide::inside) return false;
  }
  return true;
}

}  // namespace

QueryStats containment(Pose& a, Pose& b, Scratch& scratch, Containment& result) {
  detail::require(&a != &b, "containment: `a` and `b` are the same pose; give two poses");
  result = Containment::none;
  const YesNo touch = intersects(a, b, scratch);
  QueryStats work = touch;
  if (touch) return work;
  if (holds(b, a, scratch, work)) {
    result = Containment::a_in_b;
  } else if (holds(a, b, scratch, work)) {
    result = Containment::b_in_a;
  }
  return work;
}

namespace {

using detail::Cluster;
using detail::Node;
using detail::OpenedNode;
using detail::PosedTree;

Box box_of(const OpenedNode& opened, std::uint32_t slot) {
  return {{opened.low[0][slot], opened.low[1][slot], opened.low[2][slot]},
          {opened.high[0][slot], opened.high[1][slot], opened.high[2][slot]}};
}

class DeepestVertex {
 public:
  DeepestVertex(Pose& a, Pose& b, Scratch& scratch)
      : a_(a.detail().posed_tree()), surface_a_(detail::surface_of(a)), b_(b), scratch_(scratch) {}

  QueryStats run(Penetration& deepest) {
    make_table(a_);
    visit(0, Side::unknown);
    deepest = deepest_;
    return work_;
  }

 private:
  /// Side of all vertices of a slot, as far as is known.
  enum class Side { outside, inside, unknown };

  Side side_of_all(const Box& box) {
    const YesNo touches = intersects(b_, box, scratch_);
    work_ += touches;
    if (touches) return Side::unknown;
    return is_inside(box.low) ? Side::inside : Side::outside;
  }

  bool is_inside(const Vec3& point) {
    PointSide side = PointSide::outside;
    work_ += side_of(b_, point, scratch_, side);
    return side == PointSide::inside;
  }

  void visit(std::uint32_t index, Side side) {
    ++work_.node_pairs;
    const Node& node = a_.tree.nodes[index];
    const OpenedNode& opened = detail::open_node(a_, index, work_);
    for (std::uint32_t slot = 0; slot < node.cluster_count + node.child_count; ++slot) {
      const Side of_slot = side == Side::unknown ? side_of_all(box_of(opened, slot)) : side;
      if (of_slot == Side::outside) continue;
      if (slot < node.cluster_count) {
        visit(a_.tree.clusters[node.first_cluster + slot], opened, of_slot);
      } else {
        visit(node.first_child + slot - node.cluster_count, of_slot);
      }
    }
  }

  /// Visits each vertex of a cluster once.
  void visit(const Cluster& cluster, const OpenedNode& opened, Side side) {
    std::array<std::uint16_t, std::size_t{3} * detail::kMaxClusterTriangles> seen;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
      const std::uint32_t place = cluster.first_triangle + i;
      const Triangle& vertices = surface_a_.corners[a_.tree.triangle_ids[place]];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint16_t offset = a_.tree.corners[place][corner];
        if (std::find(seen.begin(), seen.begin() + count, offset) != seen.begin() + count) continue;
        seen[count++] = offset;
        const float* at = opened.positions + offset;
        consider(vertices[corner], {at[0], at[1], at[2]}, side);
      }
    }
  }

  void consider(std::uint32_t vertex, const Vec3& position, Side side) {
    const double depth = deepest_.depth;
    ClosestPoint closest;
    if (deepest_) {
      work_ += closest_point(b_, position, scratch_, closest, {.max_distance = depth});
      if (closest && (closest.distance < depth || vertex >= deepest_.vertex)) return;
    }
    if (side == Side::unknown && !is_inside(position)) return;
    if (!closest) work_ += closest_point(b_, position, scratch_, closest);
    deepest_ = {vertex, position, closest.point, closest.distance};
  }

  const PosedTree a_;
  const detail::Surface& surface_a_;
  Pose& b_;
  Scratch& scratch_;
  QueryStats work_;
  Penetration deepest_;
};

}  // namespace

QueryStats deepest_vertex(Pose& a, Pose& b, Scratch& scratch, Penetration& result) {
  detail::require(&a != &b, "deepest_vertex: `a` and `b` are the same pose; give two poses");
  detail::require(detail::surface_of(b).is_closed,
                  "deepest_vertex: the surface of `b` is not closed");
  return DeepestVertex(a, b, scratch).run(result);
}

}  // namespace pelt
