/// Descent of a moving tree against a height field. The field stands still, so a box around both
/// ends of a motion contains all its positions. Otherwise like field_collide.cpp.

#include "field/moving_field.hpp"

#include "field/moving_field_pairs.hpp"
#include "motion/moving_triangles.hpp"
#include "pose/pose_boxes.hpp"
#include "query/contact_sink.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// The box around two boxes.
FieldBox united(const FieldBox& a, const FieldBox& b) {
  FieldBox box = a;
  for (int axis = 0; axis < 3; ++axis) {
    if (b.low[axis] < box.low[axis]) box.low[axis] = b.low[axis];
    if (b.high[axis] > box.high[axis]) box.high[axis] = b.high[axis];
  }
  return box;
}

/// The box around lane `lane` of the boxes at both ends.
template <typename Boxes>
FieldBox lane_of(const Boxes& from, const Boxes& to, unsigned lane) {
  const auto box = [&](const Boxes& boxes) {
    return FieldBox{{boxes.low[0][lane], boxes.low[1][lane], boxes.low[2][lane]},
                    {boxes.high[0][lane], boxes.high[1][lane], boxes.high[2][lane]}};
  };
  return united(box(from), box(to));
}

FieldBox box_of(const RootBox& box) {
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

class MovingFieldDescent {
 public:
  MovingFieldDescent(const MovingTree& moving, const HeightField& field, Scratch& scratch,
                     const MovingOptions& options)
      : moving_(moving),
        field_(field),
        nodes_(scratch.nodes),
        sink_(scratch.moving, options.max_contacts),
        pairs_(moving.tree),
        triangles_(pairs_, scratch.moving, options, work_) {}

  MovingStats run() {
    nodes_.clear();
    sink_.contacts().clear();
    ++work_.node_pairs;
    const FieldBox root =
        united(box_of(root_box(moving_.from, work_)), box_of(root_box(moving_.to, work_)));
    if (!is_near(root)) return work_;
    make_table(moving_.from);
    make_table(moving_.to);
    nodes_.push(0);
    while (!nodes_.empty() && !sink_.is_full()) visit(nodes_.pop());
    triangles_.flush();
    work_.cut_short = sink_.cut(is_unfinished_ || !nodes_.empty());
    return work_;
  }

 private:
  /// Whether the box overlaps the range of heights below it.
  bool is_near(const FieldBox& box) const {
    FieldRect cells;
    return find_cells(field_, box, cells) && overlap(heights_of(field_, cells), box);
  }

  void visit(std::uint32_t index) {
    ++work_.node_pairs;
    const Node& node = moving_.tree.nodes.data()[index];
    const MovingNode opened = open_node(moving_, index, work_);
    for (SetBits slot(slots_of(node)); slot; ++slot) {
      if (!is_near(lane_of(opened.from, opened.to, *slot))) continue;
      if (*slot >= node.cluster_count) {
        nodes_.push(child(node, *slot));
      } else {
        if (sink_.is_full()) return void(is_unfinished_ = true);
        test({moving_, node, opened, *slot});
      }
    }
  }

  void test(const MovingCluster& c) {
    const TriangleBoxes& from = triangle_boxes(moving_.from, c.node, c.opened.from, c.slot);
    const TriangleBoxes& to = triangle_boxes(moving_.to, c.node, c.opened.to, c.slot);
    for (unsigned i = 0; i < c.cluster().triangle_count; ++i) test(c, i, lane_of(from, to, i));
    if (sink_.is_impatient()) triangles_.flush();
  }

  void test(const MovingCluster& cluster, unsigned number, const FieldBox& box) {
    FieldRect cells;
    if (!find_cells(field_, box, cells)) return;
    const auto visit = [&](const FieldTriangle& other) {
      if (sink_.is_full()) return void(is_unfinished_ = true);
      pairs_.add(cluster, number, other);
      if (pairs_.is_full()) triangles_.flush();
    };
    FieldTriangles(field_, box, cells, visit).run();
  }

  const MovingTree& moving_;
  const HeightField& field_;
  Stack<std::uint32_t>& nodes_;  // the top is visited next
  LimitedSink<MovingContact> sink_;
  MovingStats work_;
  MovingFieldPairs pairs_;
  MovingTriangles<MovingFieldPairs> triangles_;
  bool is_unfinished_ = false;  // a visit ended early
};

}  // namespace

MovingStats collide_moving_field(const MovingTree& moving, const HeightField& field,
                                 Scratch& scratch, const MovingOptions& options) {
  return MovingFieldDescent(moving, field, scratch, options).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
