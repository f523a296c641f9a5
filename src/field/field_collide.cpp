/// Descent of a tree against a height field. Skips boxes that are above or below all heights under
/// them. Generates triangles of the field under the boxes of the remaining triangles.

#include "field/field_collide.hpp"

#include "field/field_pairs.hpp"
#include "pose/open_node.hpp"
#include "query/contact_sink.hpp"
#include "query/slots.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

template <std::size_t kCount>
FieldBox lane_of(const float (&low)[3][kCount], const float (&high)[3][kCount], unsigned lane) {
  return {{low[0][lane], low[1][lane], low[2][lane]},
          {high[0][lane], high[1][lane], high[2][lane]}};
}

FieldBox box_of(const float (&low)[4], const float (&high)[4]) {
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/// Returns which of the eight boxes starting at lane `first` overlap the range of heights.
template <std::size_t kCount>
unsigned between(const float (&low)[3][kCount], const float (&high)[3][kCount], unsigned first,
                 const HeightRange& heights) {
  return ((load8(low[1] + first) <= Float8(heights.high)) &
          (Float8(heights.low) <= load8(high[1] + first)))
      .bits();
}

class FieldDescent {
 public:
  FieldDescent(const PosedTree& posed, const HeightField& field, Scratch& scratch,
               std::uint32_t max_contacts)
      : posed_(posed),
        field_(field),
        nodes_(scratch.nodes),
        sink_(scratch.found, max_contacts),
        pairs_(scratch.found, work_) {}

  QueryStats run() {
    nodes_.clear();
    sink_.contacts().clear();
    ++work_.node_pairs;
    const RootBox& root = root_box(posed_, work_);
    if (!is_near(box_of(root.low, root.high))) return work_;
    make_table(posed_);
    nodes_.push(0);
    while (!nodes_.empty() && !sink_.is_full()) visit(nodes_.pop());
    pairs_.flush();
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
    const Node& node = posed_.tree.nodes.data()[index];
    const OpenedNode& opened = open_node(posed_, index, work_);
    FieldRect cells;
    if (!find_cells(field_, box_of(opened.all_low, opened.all_high), cells)) return;
    const HeightRange heights = heights_of(field_, cells);
    for (SetBits slot(slots_of(node) & between(opened.low, opened.high, 0, heights)); slot;
         ++slot) {
      if (!is_near(lane_of(opened.low, opened.high, *slot))) continue;
      if (*slot >= node.cluster_count) {
        nodes_.push(child(node, *slot));
      } else {
        if (sink_.is_full()) return void(is_unfinished_ = true);
        test({posed_, node, opened, *slot});
      }
    }
  }

  void test(const PosedCluster& cluster) {
    const TriangleBoxes& boxes = triangle_boxes(posed_, cluster.node, cluster.opened, cluster.slot);
    const FieldBox box = lane_of(cluster.opened.low, cluster.opened.high, cluster.slot);
    FieldRect cells;
    if (!find_cells(field_, box, cells)) return;
    const HeightRange heights = heights_of(field_, cells);
    const unsigned near = between(boxes.low, boxes.high, 0, heights) |
                          between(boxes.low, boxes.high, 8, heights) << 8;
    const unsigned all = (1u << cluster.cluster().triangle_count) - 1;
    for (SetBits lane(all & near); lane; ++lane)
      test(cluster, cluster.cluster().first_triangle + *lane,
           lane_of(boxes.low, boxes.high, *lane));
    if (sink_.is_impatient()) pairs_.flush();
  }

  void test(const PosedCluster& cluster, std::uint32_t place, const FieldBox& box) {
    FieldRect cells;
    if (!find_cells(field_, box, cells)) return;
    const float* positions = cluster.opened.positions;
    const std::uint16_t* at = posed_.tree.corners.data()[place].data();
    const PosedTriangle triangle = {posed_.tree.triangle_ids.data()[place],
                                    {positions + at[0], positions + at[1], positions + at[2]}};
    const auto visit = [&](const FieldTriangle& other) {
      if (sink_.is_full()) return void(is_unfinished_ = true);
      pairs_.add(triangle, other);
    };
    FieldTriangles(field_, box, cells, visit).run();
  }

  const PosedTree& posed_;
  const HeightField& field_;
  Stack<std::uint32_t>& nodes_;  // the top is visited next
  ContactSink sink_;
  QueryStats work_;
  FieldPairs pairs_;
  bool is_unfinished_ = false;  // a visit ended early
};

}  // namespace

QueryStats collide_field(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return FieldDescent(posed, field, scratch, max_contacts).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
