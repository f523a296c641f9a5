/// Descent of a tree against a region. Boxes decide nodes, clusters and triangles that are
/// certainly outside or inside. Undecided nodes are opened, and exact tests decide undecided
/// triangles.

#include "solid/region_descent.hpp"

#include "pose/open_node.hpp"
#include "query/slots.hpp"
#include "solid/place_boxes.hpp"

#include <bit>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

template <typename AnyRegion>
class RegionDescent {
 public:
  RegionDescent(const PosedTree& posed, const AnyRegion& region, Scratch& scratch, RegionGoal goal)
      : posed_(posed), region_(region), scratch_(scratch), goal_(goal) {}

  RegionAnswer run() {
    scratch_.nodes.clear();
    scratch_.touching.clear();
    scratch_.inside.clear();
    place_root();
    while (!scratch_.nodes.empty() && !is_answered()) visit(scratch_.nodes.pop());
    return answer_;
  }

 private:
  bool wants_triangles() const { return goal_ == RegionGoal::triangles; }

  /// Whether the triangles so far decide the answer: a triangle across the boundary, or two
  /// triangles on different sides.
  bool is_answered() const {
    return !wants_triangles() && answer_.touches && (answer_.leaves || goal_ == RegionGoal::touch);
  }

  void place_root() {
    ++answer_.work.node_pairs;
    const RootBox& root = root_box(posed_, answer_.work);
    const PlacedBoxes placed = place_boxes(region_, repeat(point_box(root.low, root.high)));
    if (placed.outside & 1) {
      answer_.leaves = true;
    } else if (placed.inside & 1) {
      take_node(0);
    } else {
      make_table(posed_);
      scratch_.nodes.push(0);
    }
  }

  void visit(std::uint32_t index) {
    ++answer_.work.node_pairs;
    const Node& node = posed_.tree.nodes[index];
    const OpenedNode& opened = open_node(posed_, index, answer_.work);
    const unsigned slots = slots_of(node);
    const PlacedBoxes placed = place_boxes(region_, load_boxes(opened.low, opened.high, 0));
    if (slots & placed.outside) answer_.leaves = true;
    const unsigned inside = slots & placed.inside & ~placed.outside;
    const unsigned undecided = slots & ~(placed.inside | placed.outside);
    for (SetBits slot(inside & clusters_of(node)); slot; ++slot)
      take_cluster(node.first_cluster + *slot);
    for (SetBits slot(inside & ~clusters_of(node)); slot; ++slot) take_node(child(node, *slot));
    for (SetBits slot(undecided & ~clusters_of(node)); slot; ++slot)
      scratch_.nodes.push(child(node, *slot));
    for (SetBits slot(undecided & clusters_of(node)); slot && !is_answered(); ++slot)
      place_triangles({posed_, node, opened, *slot});
  }

  void place_triangles(const PosedCluster& cluster) {
    const TriangleBoxes& boxes = triangle_boxes(posed_, cluster.node, cluster.opened, cluster.slot);
    const unsigned all = (1u << cluster.cluster().triangle_count) - 1;
    const PlacedBoxes first = place_boxes(region_, load_boxes(boxes.low, boxes.high, 0));
    const PlacedBoxes last = place_boxes(region_, load_boxes(boxes.low, boxes.high, 8));
    const unsigned outside = all & (first.outside | last.outside << 8);
    const unsigned inside = all & (first.inside | last.inside << 8) & ~outside;
    if (outside) answer_.leaves = true;
    for (SetBits triangle(inside); triangle; ++triangle)
      take(cluster.cluster().first_triangle + *triangle);
    for (SetBits triangle(all & ~(outside | inside)); triangle && !is_answered(); ++triangle)
      place_triangle(cluster, cluster.cluster().first_triangle + *triangle);
  }

  void place_triangle(const PosedCluster& cluster, std::uint32_t triangle) {
    ++answer_.work.triangle_pairs;
    TriangleCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const float* p = cluster.opened.positions + posed_.tree.corners[triangle][k];
      corners[k] = {p[0], p[1], p[2]};
    }
    const TrianglePlace place = place_in(region_, corners);
    if (place == TrianglePlace::inside) return take(triangle);
    answer_.leaves = true;
    if (place == TrianglePlace::apart) return;
    answer_.touches = true;
    if (wants_triangles()) scratch_.touching.push(posed_.tree.triangle_ids[triangle]);
  }

  /// Adds a triangle that is inside.
  void take(std::uint32_t triangle) {
    answer_.touches = true;
    if (!wants_triangles()) return;
    scratch_.touching.push(posed_.tree.triangle_ids[triangle]);
    scratch_.inside.push(posed_.tree.triangle_ids[triangle]);
  }

  void take_cluster(std::uint32_t index) {
    answer_.touches = true;
    if (!wants_triangles()) return;
    const Cluster& cluster = posed_.tree.clusters[index];
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) take(cluster.first_triangle + i);
  }

  void take_node(std::uint32_t index) {
    answer_.touches = true;
    if (!wants_triangles()) return;
    const Node& node = posed_.tree.nodes[index];
    for (std::uint32_t c = 0; c < node.cluster_count; ++c) take_cluster(node.first_cluster + c);
    for (std::uint32_t c = 0; c < node.child_count; ++c) take_node(node.first_child + c);
  }

  const PosedTree& posed_;
  const AnyRegion& region_;
  Scratch& scratch_;
  RegionGoal goal_;
  RegionAnswer answer_;
};

}  // namespace

RegionAnswer descend_in_faces(const PosedTree& posed, const FacesRegion& region, Scratch& scratch,
                              RegionGoal goal) {
  return RegionDescent<FacesRegion>(posed, region, scratch, goal).run();
}

RegionAnswer descend_in_capsule(const PosedTree& posed, const CapsuleRegion& region,
                                Scratch& scratch, RegionGoal goal) {
  return RegionDescent<CapsuleRegion>(posed, region, scratch, goal).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
