/// Descent of a moving tree against a region. Boxes at both ends of the step decide nodes, clusters
/// and triangles that are certainly outside throughout, or inside at an end. Undecided nodes are
/// opened at both ends, and undecided triangles are decided one by one (decide_touch.hpp).

#include "solid/moving_descent.hpp"

#include "query/contact_sink.hpp"
#include "query/triangle_batch.hpp"
#include "solid/decide_touch.hpp"
#include "solid/place_moving_boxes.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

template <typename AnyRegion>
class MovingDescent {
 public:
  MovingDescent(const MovingTree& moving, const AnyRegion& region, Scratch& scratch,
                const MovingOptions& options)
      : moving_(moving),
        region_(region),
        nodes_(scratch.nodes),
        sink_(scratch.moving, options.max_contacts),
        options_(options) {}

  MovingStats run() {
    nodes_.clear();
    sink_.contacts().clear();
    place_root();
    while (!nodes_.empty() && !sink_.is_full()) visit(nodes_.pop());
    work_.cut_short = sink_.cut(is_unfinished_ || !nodes_.empty());
    return work_;
  }

 private:
  /// What boxes say about eight nodes, clusters or triangles, one bit each.
  struct Verdict {
    unsigned at_start, touching, undecided;
  };

  Verdict judge(unsigned asked, const Boxes8& from, const Boxes8& to) const {
    const PlacedMovingBoxes placed = place_moving_boxes(region_, from, to);
    const unsigned left = asked & ~placed.outside, at_start = left & placed.inside_from;
    if (options_.leave_out_start) return {0, 0, left & ~at_start};
    const unsigned touching = options_.times ? 0 : left & ~at_start & placed.inside_to;
    return {at_start, touching, left & ~(at_start | touching)};
  }

  void place_root() {
    ++work_.node_pairs;
    const RootBox &from = root_box(moving_.from, work_), &to = root_box(moving_.to, work_);
    const Verdict verdict =
        judge(1, repeat(point_box(from.low, from.high)), repeat(point_box(to.low, to.high)));
    if (verdict.at_start | verdict.touching) return take_node(0, verdict.at_start != 0);
    if (verdict.undecided == 0) return;
    make_table(moving_.from);
    make_table(moving_.to);
    nodes_.push(0);
  }

  void visit(std::uint32_t index) {
    ++work_.node_pairs;
    const Node& node = moving_.tree.nodes.data()[index];
    const MovingNode opened = open_node(moving_, index, work_);
    const Verdict verdict = judge(slots_of(node), load_boxes(opened.from.low, opened.from.high, 0),
                                  load_boxes(opened.to.low, opened.to.high, 0));
    for (SetBits slot(verdict.at_start); slot; ++slot) take_slot(node, *slot, true);
    for (SetBits slot(verdict.touching); slot; ++slot) take_slot(node, *slot, false);
    for (SetBits slot(verdict.undecided & ~clusters_of(node)); slot; ++slot)
      nodes_.push(child(node, *slot));
    for (SetBits slot(verdict.undecided & clusters_of(node)); slot; ++slot) {
      if (sink_.is_full()) return void(is_unfinished_ = true);
      judge_triangles({moving_, node, opened, *slot});
    }
  }

  void judge_triangles(const MovingCluster& c) {
    const TriangleBoxes& from = triangle_boxes(moving_.from, c.node, c.opened.from, c.slot);
    const TriangleBoxes& to = triangle_boxes(moving_.to, c.node, c.opened.to, c.slot);
    const unsigned all = (1u << c.cluster().triangle_count) - 1;
    for (unsigned first = 0; all >> first != 0; first += 8) {
      const Verdict verdict = judge(all >> first & 0xFF, load_boxes(from.low, from.high, first),
                                    load_boxes(to.low, to.high, first));
      const std::uint32_t begin = c.cluster().first_triangle + first;
      for (SetBits i(verdict.at_start); i; ++i) take(begin + *i, true);
      for (SetBits i(verdict.touching); i; ++i) take(begin + *i, false);
      for (SetBits i(verdict.undecided); i; ++i) {
        if (sink_.is_full()) return void(is_unfinished_ = true);
        decide(c, begin + *i);
      }
    }
  }

  void decide(const MovingCluster& c, std::uint32_t triangle) {
    const auto corners = [&](const OpenedNode& opened) {
      return corners_at(
          [&](std::size_t k) { return opened.positions + moving_.tree.corners[triangle][k]; });
    };
    const MovingTriangle moving{corners(c.opened.from), corners(c.opened.to)};
    if (const auto touch = decide_touch(region_, moving, options_, work_)) push(triangle, *touch);
  }

  void push(std::uint32_t triangle, const FirstTouch& touch) {
    const bool at_start = options_.times && touch.at_start;
    sink_.contacts().push({{moving_.tree.triangle_ids[triangle], 0}, touch.time, at_start, {}, {}});
  }

  /// Adds a triangle that touches the region, at the start or at a time that need not be known.
  void take(std::uint32_t triangle, bool at_start) {
    if (sink_.is_full()) return void(is_unfinished_ = true);
    push(triangle, {0, at_start});
  }

  void take_cluster(std::uint32_t index, bool at_start) {
    const Cluster& cluster = moving_.tree.clusters[index];
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i)
      take(cluster.first_triangle + i, at_start);
  }

  void take_node(std::uint32_t index, bool at_start) {
    const Node& node = moving_.tree.nodes.data()[index];
    for (std::uint32_t c = 0; c < node.cluster_count; ++c)
      take_cluster(node.first_cluster + c, at_start);
    for (std::uint32_t c = 0; c < node.child_count; ++c) take_node(node.first_child + c, at_start);
  }

  void take_slot(const Node& node, unsigned slot, bool at_start) {
    if (slot < node.cluster_count) {
      take_cluster(node.first_cluster + slot, at_start);
    } else {
      take_node(child(node, slot), at_start);
    }
  }

  const MovingTree& moving_;
  const AnyRegion& region_;
  Stack<std::uint32_t>& nodes_;
  LimitedSink<MovingContact> sink_;
  const MovingOptions& options_;
  MovingStats work_;
  bool is_unfinished_ = false;  // triangles were left out because of the limit
};

}  // namespace

MovingStats descend_moving_in_faces(const MovingTree& moving, const FacesRegion& region,
                                    Scratch& scratch, const MovingOptions& options) {
  return MovingDescent<FacesRegion>(moving, region, scratch, options).run();
}

MovingStats descend_moving_in_capsule(const MovingTree& moving, const CapsuleRegion& region,
                                      Scratch& scratch, const MovingOptions& options) {
  return MovingDescent<CapsuleRegion>(moving, region, scratch, options).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
