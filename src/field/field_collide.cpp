/// Descent of a tree, still or moving, against a height field. Skips boxes that are above or below
/// all heights under them. Generates triangles of the field under the boxes of the remaining
/// triangles. The field stands still, so a box around both ends of a step contains all positions.

#include "field/field_trees.hpp"

#include "field/field_cells.hpp"
#include "motion/moving_pairs.hpp"
#include "pose/open_node.hpp"
#include "query/contact_sink.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

// The boxes and corners that the descent reads, of a posed tree and of a step.

FieldBox box_of(const float (&low)[4], const float (&high)[4]) {
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/// The box around two boxes.
FieldBox united(const FieldBox& a, const FieldBox& b) {
  FieldBox box = a;
  for (int axis = 0; axis < 3; ++axis) {
    if (b.low[axis] < box.low[axis]) box.low[axis] = b.low[axis];
    if (b.high[axis] > box.high[axis]) box.high[axis] = b.high[axis];
  }
  return box;
}

FieldBox root_of(const PosedTree& posed, QueryStats& work) {
  const RootBox& root = root_box(posed, work);
  return box_of(root.low, root.high);
}

FieldBox root_of(const MovingTree& moving, QueryStats& work) {
  return united(root_of(moving.from, work), root_of(moving.to, work));
}

FieldBox box_of_all(const OpenedNode& opened) { return box_of(opened.all_low, opened.all_high); }

FieldBox box_of_all(const MovingNode& opened) {
  return united(box_of_all(opened.from), box_of_all(opened.to));
}

const TriangleBoxes& boxes_of(const PosedCluster& c) {
  return triangle_boxes(c.posed, c.node, c.opened, c.slot);
}

MovingTriangleBoxes boxes_of(const MovingCluster& c) { return MovingTriangleBoxes(c); }

template <typename Boxes>
concept AtBothEnds = requires(const Boxes& boxes) {
  boxes.from;
  boxes.to;
};

/// One box of a node's slots or of a cluster's triangles.
template <typename Boxes>
FieldBox lane_of(const Boxes& boxes, unsigned lane) {
  if constexpr (AtBothEnds<Boxes>)
    return united(lane_of(boxes.from, lane), lane_of(boxes.to, lane));
  else
    return {{boxes.low[0][lane], boxes.low[1][lane], boxes.low[2][lane]},
            {boxes.high[0][lane], boxes.high[1][lane], boxes.high[2][lane]}};
}

/// The heights of the eight boxes starting at lane `first`.
struct Heights8 {
  template <typename Boxes>
  Heights8(const Boxes& boxes, unsigned first)
      : low(load8(boxes.low[1] + first)), high(load8(boxes.high[1] + first)) {}

  template <AtBothEnds Boxes>
  Heights8(const Boxes& boxes, unsigned first) : Heights8(boxes.from, first) {
    const Heights8 to(boxes.to, first);
    low = min(low, to.low);
    high = max(high, to.high);
  }

  Float8 low, high;
};

/// Returns which of the eight boxes starting at lane `first` overlap the range of heights.
template <typename Boxes>
unsigned between(const Boxes& boxes, unsigned first, const HeightRange& heights) {
  const Heights8 of(boxes, first);
  return ((of.low <= Float8(heights.high)) & (Float8(heights.low) <= of.high)).bits();
}

/// Pairs of a triangle of a tree and a triangle of a height field that wait until there are eight.
class WaitingFieldPairs {
 public:
  explicit WaitingFieldPairs(const Tree& tree) : tree_(tree) {}

  bool is_full() const { return waiting_.is_full(); }
  std::uint32_t count() const { return waiting_.count(); }
  void clear() { waiting_.clear(); }

  Contact contact(unsigned lane) const {
    return {tree_.triangle_ids.data()[waiting_[lane].triangle], waiting_[lane].field.number};
  }

 protected:
  struct Pair {
    std::uint32_t triangle;  ///< into Tree::corners
    const float *from, *to;  ///< its posed pools, which are the same in a still tree
    FieldTriangle field;
  };

  void add(const Pair& pair) { waiting_.add(pair); }
  void pad() { waiting_.pad(); }

  void tree_corners8(const float* Pair::*end, Points8 (&corners)[3]) const {
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = gather_points([&](std::uint32_t lane) { return corner(lane, end, k); });
  }

  void field_corners8(Points8 (&corners)[3]) const {
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] =
          gather_points([&](std::uint32_t lane) { return waiting_[lane].field.corners[k]; });
  }

  TriangleCorners tree_corners(unsigned lane, const float* Pair::*end) const {
    return corners_at([&](std::size_t k) { return corner(lane, end, k); });
  }

  TriangleCorners field_corners(unsigned lane) const {
    return corners_at([&](std::size_t k) { return waiting_[lane].field.corners[k]; });
  }

 private:
  const float* corner(std::uint32_t lane, const float* Pair::*end, std::size_t k) const {
    const Pair& pair = waiting_[lane];
    return pair.*end + tree_.corners.data()[pair.triangle][k];
  }

  const Tree& tree_;
  Batch8<Pair> waiting_;
};

/// Tests pairs of a posed tree: by the certified float test, and the rest by the exact predicate.
class FieldPairs : WaitingFieldPairs {
 public:
  using View = PosedTree;
  using AnyCluster = PosedCluster;

  FieldPairs(const Tree& tree, const ContactSink& sink, QueryStats& work)
      : WaitingFieldPairs(tree), sink_(sink), work_(work) {}

  void add(const PosedCluster& c, std::uint32_t triangle, const FieldTriangle& field) {
    WaitingFieldPairs::add({triangle, c.opened.positions, c.opened.positions, field});
    if (is_full()) flush();
  }

  void flush() {
    if (count() == 0) return;
    pad();
    TrianglePairs8 pairs;
    tree_corners8(&Pair::from, pairs.a);
    field_corners8(pairs.b);
    const unsigned kept = (1u << count()) - 1;
    const Triage verdict = triage(pairs);
    const unsigned exact = decide_exactly(
        verdict, kept, [&](unsigned lane) { return tree_corners(lane, &Pair::from); },
        [&](unsigned lane) { return field_corners(lane); });
    for (SetBits lane((kept & verdict.intersecting) | exact); lane; ++lane)
      sink_.push(contact(*lane));
    work_.triangle_pairs += count();
    clear();
  }

 private:
  const ContactSink& sink_;
  QueryStats& work_;
};

/// Pairs of a moving tree, for MovingTrianglePairs.
class WaitingMovingFieldPairs : public WaitingFieldPairs {
 public:
  using WaitingFieldPairs::WaitingFieldPairs;

  void add(const MovingCluster& c, std::uint32_t triangle, const FieldTriangle& field) {
    WaitingFieldPairs::add({triangle, c.opened.from.positions, c.opened.to.positions, field});
  }

  MovingPairs8 corners8() {
    pad();
    MovingPairs8 pairs;
    tree_corners8(&Pair::from, pairs.from.a);
    tree_corners8(&Pair::to, pairs.to.a);
    field_corners8(pairs.from.b);
    for (std::size_t k = 0; k < 3; ++k) pairs.to.b[k] = pairs.from.b[k];
    return pairs;
  }

  MovingTriangle triangle_a(unsigned lane) const {
    return {tree_corners(lane, &Pair::from), tree_corners(lane, &Pair::to)};
  }

  /// Stands still.
  MovingTriangle triangle_b(unsigned lane) const {
    const TriangleCorners corners = field_corners(lane);
    return {corners, corners};
  }
};

/// Tests pairs of a moving tree.
class MovingFieldPairs {
 public:
  using View = MovingTree;
  using AnyCluster = MovingCluster;

  MovingFieldPairs(const Tree& tree, const LimitedSink<MovingContact>& sink,
                   const MovingOptions& options, MovingStats& work)
      : pairs_(tree), triangles_(pairs_, sink, options, work) {}

  void add(const MovingCluster& c, std::uint32_t triangle, const FieldTriangle& field) {
    pairs_.add(c, triangle, field);
    if (pairs_.is_full()) flush();
  }

  void flush() { triangles_.flush(); }

 private:
  WaitingMovingFieldPairs pairs_;
  MovingTrianglePairs<WaitingMovingFieldPairs, const LimitedSink<MovingContact>> triangles_;
};

/// `Pairs`: FieldPairs or MovingFieldPairs.
template <typename Pairs, typename Sink>
class FieldDescent {
 public:
  using View = typename Pairs::View;
  using AnyCluster = typename Pairs::AnyCluster;

  FieldDescent(const View& view, const HeightField& field, Stack<std::uint32_t>& nodes,
               Pairs& pairs, const Sink& sink, QueryStats& work)
      : view_(view), field_(field), nodes_(nodes), pairs_(pairs), sink_(sink), work_(work) {}

  void run() {
    nodes_.clear();
    sink_.contacts().clear();
    ++work_.node_pairs;
    if (!is_near(root_of(view_, work_))) return;
    make_table(view_);
    nodes_.push(0);
    while (!nodes_.empty() && !sink_.is_full()) visit(nodes_.pop());
    pairs_.flush();
    work_.cut_short = sink_.cut(is_unfinished_ || !nodes_.empty());
  }

 private:
  /// Whether the box overlaps the range of heights below it.
  bool is_near(const FieldBox& box) const {
    FieldRect cells;
    return find_cells(field_, box, cells) && overlap(heights_of(field_, cells), box);
  }

  void visit(std::uint32_t index) {
    ++work_.node_pairs;
    const Node& node = view_.tree.nodes.data()[index];
    const auto& opened = open_node(view_, index, work_);
    FieldRect cells;
    if (!find_cells(field_, box_of_all(opened), cells)) return;
    const HeightRange heights = heights_of(field_, cells);
    for (SetBits slot(slots_of(node) & between(opened, 0, heights)); slot; ++slot) {
      if (!is_near(lane_of(opened, *slot))) continue;
      if (*slot >= node.cluster_count) {
        nodes_.push(child(node, *slot));
      } else {
        if (sink_.is_full()) return void(is_unfinished_ = true);
        test(AnyCluster{view_, node, opened, *slot});
      }
    }
  }

  void test(const AnyCluster& cluster) {
    const auto& boxes = boxes_of(cluster);
    FieldRect cells;
    if (!find_cells(field_, lane_of(cluster.opened, cluster.slot), cells)) return;
    const HeightRange heights = heights_of(field_, cells);
    const unsigned near = between(boxes, 0, heights) | between(boxes, 8, heights) << 8;
    const unsigned all = (1u << cluster.cluster().triangle_count) - 1;
    for (SetBits lane(all & near); lane; ++lane)
      test(cluster, cluster.cluster().first_triangle + *lane, lane_of(boxes, *lane));
    if (sink_.is_impatient()) pairs_.flush();
  }

  void test(const AnyCluster& cluster, std::uint32_t triangle, const FieldBox& box) {
    FieldRect cells;
    if (!find_cells(field_, box, cells)) return;
    const auto visit = [&](const FieldTriangle& other) {
      if (sink_.is_full()) return void(is_unfinished_ = true);
      pairs_.add(cluster, triangle, other);
    };
    FieldTriangles(field_, box, cells, visit).run();
  }

  const View& view_;
  const HeightField& field_;
  Stack<std::uint32_t>& nodes_;  // the top is visited next
  Pairs& pairs_;
  const Sink& sink_;
  QueryStats& work_;
  bool is_unfinished_ = false;  // a visit ended early
};

}  // namespace

QueryStats collide_field(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  QueryStats work;
  const ContactSink sink(scratch.found, max_contacts);
  FieldPairs pairs(posed.tree, sink, work);
  FieldDescent(posed, field, scratch.nodes, pairs, sink, work).run();
  return work;
}

MovingStats collide_moving_field(const MovingTree& moving, const HeightField& field,
                                 Scratch& scratch, const MovingOptions& options) {
  MovingStats work;
  const LimitedSink sink(scratch.moving, options.max_contacts);
  MovingFieldPairs pairs(moving.tree, sink, options, work);
  FieldDescent(moving, field, scratch.nodes, pairs, sink, work).run();
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
