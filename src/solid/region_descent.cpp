/// Descent of a tree, still or moving, against a region. Boxes decide nodes, clusters and triangles
/// that are certainly outside or inside: of a step, outside throughout, or inside at an end.
/// Undecided nodes are opened, and exact tests decide undecided triangles.

#include "solid/region_descent.hpp"

#include "motion/moving_pairs.hpp"
#include "pose/open_node.hpp"
#include "query/contact_sink.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"
#include "solid/place_boxes.hpp"
#include "solid/region_triangle.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

// The boxes and corners that the descent reads, of a posed tree and of a step.

Boxes8 root_boxes(const PosedTree& posed, QueryStats& work) {
  const RootBox& root = root_box(posed, work);
  return repeat(point_box(root.low, root.high));
}

MovingBoxes8 root_boxes(const MovingTree& moving, QueryStats& work) {
  return {root_boxes(moving.from, work), root_boxes(moving.to, work)};
}

/// Eight boxes of a node's slots or of a cluster's triangles.
template <typename Boxes>
Boxes8 boxes_at(const Boxes& boxes, unsigned first) {
  return load_boxes(boxes.low, boxes.high, first);
}

MovingBoxes8 boxes_at(const MovingNode& node, unsigned first) {
  return {boxes_at(node.from, first), boxes_at(node.to, first)};
}

MovingBoxes8 boxes_at(const MovingTriangleBoxes& boxes, unsigned first) {
  return {boxes_at(boxes.from, first), boxes_at(boxes.to, first)};
}

const TriangleBoxes& triangle_boxes_of(const PosedCluster& c) {
  return triangle_boxes(c.posed, c.node, c.opened, c.slot);
}

MovingTriangleBoxes triangle_boxes_of(const MovingCluster& c) { return MovingTriangleBoxes(c); }

TriangleCorners corners_of(const Tree& tree, const OpenedNode& opened, std::uint32_t triangle) {
  return corners_at([&](std::size_t k) { return opened.positions + tree.corners[triangle][k]; });
}

/// The result of testing the boxes of up to 16 nodes, clusters or triangles, one bit each. Boxes
/// that are neither taken nor undecided are skipped.
struct Verdict {
  unsigned at_start, later;  ///< taken: they touch the region at the start, or later in the step
  unsigned undecided;
};

/// A posed tree. Triangles are taken that are inside.
template <typename AnyRegion>
class StillRule {
 public:
  using View = PosedTree;
  using AnyCluster = PosedCluster;

  /// How many triangles are judged before undecided ones are tested.
  static constexpr unsigned kAtOnce = kMaxClusterTriangles;

  StillRule(const PosedTree& posed, const AnyRegion& region, Scratch& scratch, RegionGoal goal)
      : tree_(posed.tree), region_(region), scratch_(scratch), goal_(goal) {
    scratch.touching.clear();
    scratch.inside.clear();
  }

  QueryStats& work() { return answer_.work; }
  const RegionAnswer& answer() const { return answer_; }

  /// Whether the triangles so far decide the answer: a triangle across the boundary, or two
  /// triangles on different sides.
  bool is_answered() const {
    return !lists_triangles() && answer_.touches && (answer_.leaves || goal_ == RegionGoal::touch);
  }

  bool lists_triangles() const { return goal_ == RegionGoal::triangles; }

  /// Notes that triangles are taken that need not be listed.
  void take_unlisted() { answer_.touches = true; }

  Verdict judge(unsigned asked, const Boxes8& boxes) {
    const PlacedBoxes placed = place_boxes(region_, boxes);
    return verdict(asked, placed.outside, placed.inside);
  }

  Verdict judge_triangles(unsigned all, const TriangleBoxes& boxes, unsigned) {
    const PlacedBoxes first = place_boxes(region_, boxes_at(boxes, 0));
    const PlacedBoxes last = place_boxes(region_, boxes_at(boxes, 8));
    return verdict(all, first.outside | last.outside << 8, first.inside | last.inside << 8);
  }

  /// Adds a triangle that is inside.
  void take(std::uint32_t triangle, bool) {
    answer_.touches = true;
    if (!lists_triangles()) return;
    scratch_.touching.push(tree_.triangle_ids[triangle]);
    scratch_.inside.push(tree_.triangle_ids[triangle]);
  }

  void decide(const PosedCluster& cluster, std::uint32_t triangle) {
    ++answer_.work.triangle_pairs;
    const TrianglePlace place = place_in(region_, corners_of(tree_, cluster.opened, triangle));
    if (place == TrianglePlace::inside) return take(triangle, true);
    answer_.leaves = true;
    if (place == TrianglePlace::apart) return;
    answer_.touches = true;
    if (lists_triangles()) scratch_.touching.push(tree_.triangle_ids[triangle]);
  }

 private:
  Verdict verdict(unsigned asked, unsigned outside, unsigned inside) {
    if (asked & outside) answer_.leaves = true;
    return {asked & inside & ~outside, 0, asked & ~(inside | outside)};
  }

  const Tree& tree_;
  const AnyRegion& region_;
  Scratch& scratch_;
  RegionGoal goal_;
  RegionAnswer answer_;
};

/// A step. Triangles are taken that touch the region at the start or at a time that need not be
/// known.
template <typename AnyRegion>
class MovingRule {
 public:
  using View = MovingTree;
  using AnyCluster = MovingCluster;

  static constexpr unsigned kAtOnce = 8;

  MovingRule(const MovingTree& moving, const AnyRegion& region,
             const LimitedSink<MovingContact>& sink, const MovingOptions& options,
             MovingStats& work)
      : tree_(moving.tree), region_(region), sink_(sink), options_(options), work_(work) {
    sink.contacts().clear();
  }

  QueryStats& work() { return work_; }

  bool is_answered() const { return sink_.is_full(); }

  static constexpr bool lists_triangles() { return true; }
  static void take_unlisted() {}

  Verdict judge(unsigned asked, const MovingBoxes8& boxes) const {
    const PlacedMovingBoxes placed = place_moving_boxes(region_, boxes.from, boxes.to);
    const unsigned left = asked & ~placed.outside, at_start = left & placed.inside_from;
    if (options_.leave_out_start) return {0, 0, left & ~at_start};
    const unsigned later = options_.times ? 0 : left & ~at_start & placed.inside_to;
    return {at_start, later, left & ~(at_start | later)};
  }

  Verdict judge_triangles(unsigned all, const MovingTriangleBoxes& boxes, unsigned first) const {
    return judge(all >> first & 0xFF, boxes_at(boxes, first));
  }

  void take(std::uint32_t triangle, bool at_start) { push(triangle, {0, at_start}); }

  void decide(const MovingCluster& cluster, std::uint32_t triangle) {
    const MovingTriangle moving{corners_of(tree_, cluster.opened.from, triangle),
                                corners_of(tree_, cluster.opened.to, triangle)};
    if (const auto touch = decide_touch(region_, moving, options_, work_)) push(triangle, *touch);
  }

 private:
  void push(std::uint32_t triangle, const FirstTouch& touch) {
    const bool at_start = options_.times && touch.at_start;
    sink_.push({{tree_.triangle_ids[triangle], 0}, touch.time, at_start, {}, {}});
  }

  const Tree& tree_;
  const AnyRegion& region_;
  const LimitedSink<MovingContact>& sink_;
  const MovingOptions& options_;
  MovingStats& work_;
};

/// `Rule`: StillRule or MovingRule.
template <typename Rule>
class RegionDescent {
 public:
  using View = typename Rule::View;
  using AnyCluster = typename Rule::AnyCluster;

  RegionDescent(const View& view, Stack<std::uint32_t>& nodes, Rule& rule)
      : view_(view), nodes_(nodes), rule_(rule) {}

  /// Returns whether something is left, because the triangles so far answer the question.
  bool run() {
    nodes_.clear();
    place_root();
    while (!nodes_.empty() && !rule_.is_answered()) visit(nodes_.pop());
    return is_unfinished_ || !nodes_.empty();
  }

 private:
  void place_root() {
    ++rule_.work().node_pairs;
    const Verdict verdict = rule_.judge(1, root_boxes(view_, rule_.work()));
    if (verdict.at_start | verdict.later) return take_node(0, verdict.at_start != 0);
    if (verdict.undecided == 0) return;
    make_table(view_);
    nodes_.push(0);
  }

  void visit(std::uint32_t index) {
    ++rule_.work().node_pairs;
    const Node& node = view_.tree.nodes.data()[index];
    const auto& opened = open_node(view_, index, rule_.work());
    const Verdict verdict = rule_.judge(slots_of(node), boxes_at(opened, 0));
    for (SetBits slot(verdict.at_start); slot; ++slot) take_slot(node, *slot, true);
    for (SetBits slot(verdict.later); slot; ++slot) take_slot(node, *slot, false);
    for (SetBits slot(verdict.undecided & ~clusters_of(node)); slot; ++slot)
      nodes_.push(child(node, *slot));
    for (SetBits slot(verdict.undecided & clusters_of(node)); slot; ++slot) {
      if (rule_.is_answered()) return void(is_unfinished_ = true);
      judge_triangles({view_, node, opened, *slot});
    }
  }

  void judge_triangles(const AnyCluster& cluster) {
    const auto& boxes = triangle_boxes_of(cluster);
    const unsigned all = (1u << cluster.cluster().triangle_count) - 1;
    for (unsigned first = 0; all >> first != 0; first += Rule::kAtOnce) {
      const Verdict verdict = rule_.judge_triangles(all, boxes, first);
      const std::uint32_t begin = cluster.cluster().first_triangle + first;
      for (SetBits i(verdict.at_start); i; ++i) take(begin + *i, true);
      for (SetBits i(verdict.later); i; ++i) take(begin + *i, false);
      for (SetBits i(verdict.undecided); i; ++i) {
        if (rule_.is_answered()) return void(is_unfinished_ = true);
        rule_.decide(cluster, begin + *i);
      }
    }
  }

  void take(std::uint32_t triangle, bool at_start) {
    if (rule_.is_answered()) return void(is_unfinished_ = true);
    rule_.take(triangle, at_start);
  }

  void take_cluster(std::uint32_t index, bool at_start) {
    const Cluster& cluster = view_.tree.clusters[index];
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i)
      take(cluster.first_triangle + i, at_start);
  }

  void take_node(std::uint32_t index, bool at_start) {
    if (!rule_.lists_triangles()) return rule_.take_unlisted();
    const Node& node = view_.tree.nodes.data()[index];
    for (std::uint32_t c = 0; c < node.cluster_count; ++c)
      take_cluster(node.first_cluster + c, at_start);
    for (std::uint32_t c = 0; c < node.child_count; ++c) take_node(node.first_child + c, at_start);
  }

  void take_slot(const Node& node, unsigned slot, bool at_start) {
    if (!rule_.lists_triangles()) return rule_.take_unlisted();
    if (slot < node.cluster_count) {
      take_cluster(node.first_cluster + slot, at_start);
    } else {
      take_node(child(node, slot), at_start);
    }
  }

  const View& view_;
  Stack<std::uint32_t>& nodes_;
  Rule& rule_;
  bool is_unfinished_ = false;  // triangles were left out
};

template <typename AnyRegion>
RegionAnswer descend(const PosedTree& posed, const AnyRegion& region, Scratch& scratch,
                     RegionGoal goal) {
  StillRule rule(posed, region, scratch, goal);
  RegionDescent(posed, scratch.nodes, rule).run();
  return rule.answer();
}

template <typename AnyRegion>
MovingStats descend_moving(const MovingTree& moving, const AnyRegion& region, Scratch& scratch,
                           const MovingOptions& options) {
  MovingStats work;
  const LimitedSink sink(scratch.moving, options.max_contacts);
  MovingRule rule(moving, region, sink, options, work);
  const bool is_unfinished = RegionDescent(moving, scratch.nodes, rule).run();
  work.cut_short = sink.cut(is_unfinished);
  return work;
}

}  // namespace

RegionAnswer descend_in_faces(const PosedTree& posed, const FacesRegion& region, Scratch& scratch,
                              RegionGoal goal) {
  return descend(posed, region, scratch, goal);
}

RegionAnswer descend_in_capsule(const PosedTree& posed, const CapsuleRegion& region,
                                Scratch& scratch, RegionGoal goal) {
  return descend(posed, region, scratch, goal);
}

MovingStats descend_moving_in_faces(const MovingTree& moving, const FacesRegion& region,
                                    Scratch& scratch, const MovingOptions& options) {
  return descend_moving(moving, region, scratch, options);
}

MovingStats descend_moving_in_capsule(const MovingTree& moving, const CapsuleRegion& region,
                                      Scratch& scratch, const MovingOptions& options) {
  return descend_moving(moving, region, scratch, options);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
