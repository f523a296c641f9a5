/// Nearest-first descent of a tree and of the blocks of a height field, like that of two trees
/// (distance_search.cpp). The larger of a part and a block is replaced by its slots or by its four
/// sub-blocks, nearest first.

#include "field/field_trees.hpp"

#include "distance/distance_search.hpp"
#include "distance/triangle_gaps.hpp"
#include "field/field_cells.hpp"
#include "pose/open_node.hpp"
#include "query/nearest_search.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Boxes of blocks or triangles of a field in structure-of-arrays order. Infinite boxes are
/// infinitely far away.
template <std::size_t kCount>
struct alignas(32) FieldBoxes {
  float low[3][kCount], high[3][kCount];

  void clear() {
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < kCount; ++i) low[axis][i] = high[axis][i] = HUGE_VALF;
  }
};

/// A block, by its level and its number on the level.
struct Block {
  std::uint32_t level, number;
};

/// The triangles of a block of the lowest level, and their boxes.
class BlockTriangles {
 public:
  static constexpr std::uint32_t kMax = 2u << 2 * kBlockShift;

  BlockTriangles() { boxes_.clear(); }

  void add(const FieldTriangle& triangle) {
    for (int axis = 0; axis < 3; ++axis) {
      const float a = triangle.corners[0][axis], b = triangle.corners[1][axis],
                  c = triangle.corners[2][axis];
      const float least = a < b ? a : b, most = a < b ? b : a;
      boxes_.low[axis][count_] = c < least ? c : least;
      boxes_.high[axis][count_] = most < c ? c : most;
    }
    triangles_[count_++] = triangle;
  }

  /// Computes the squared distances to a box.
  void gaps_to(const Box8& box, float (&gaps)[kMax]) const {
    for (unsigned first = 0; first < kMax; first += 8)
      squared_gaps(boxes_.low, boxes_.high, first, box).store(gaps + first);
  }

  std::uint32_t count() const { return count_; }
  const FieldTriangle& operator[](std::uint32_t i) const { return triangles_[i]; }

 private:
  FieldBoxes<kMax> boxes_;
  FieldTriangle triangles_[kMax];
  std::uint32_t count_ = 0;
};

/// Returns the index of the least value, or `count` if all values exceed `most`.
std::uint32_t least_of(const float* values, std::uint32_t count, float most) {
  std::uint32_t least = count;
  for (std::uint32_t i = 0; i < count; ++i)
    if (values[i] <= (least == count ? most : values[least])) least = i;
  return least;
}

double extent(const RootBox& root, const FieldBox& field) {
  return common_extent(root.low, root.high, field.low, field.high);
}

class FieldSearch {
 public:
  FieldSearch(const PosedTree& posed, const HeightField& field, Scratch& scratch,
              const SearchLimits& limits, TriangleGap& best)
      : posed_(posed),
        field_(field),
        parts_(scratch.near_parts),
        limits_(limits),
        goal_(limits, best),
        top_{static_cast<std::uint32_t>(field.levels.size()) - 1, 0},
        reach_(extent(root_box(posed, work_), box_of(top_))) {
    reach_.set(limits.max_distance);
  }

  QueryStats run() {
    parts_.clear();
    ++work_.node_pairs;
    const RootBox& root = root_box(posed_, work_);
    if (!is_within_reach(point_box(root.low, root.high), box8(box_of(top_)))) return work_;
    make_table(posed_);
    if (limits_.begin) look_first(*limits_.begin);
    parts_.push({0, 0, TreePart::kWhole, top_.level, top_.number});
    while (!parts_.empty()) {
      const NearParts pair = parts_.pop();
      if (pair.squared_gap <= reach_.squared_gap())
        visit({pair.node_a, pair.slot_a}, {pair.node_b, pair.slot_b});
    }
    return work_;
  }

 private:
  static Box8 box8(const FieldBox& box) {
    return {{Float8(box.low[0]), Float8(box.low[1]), Float8(box.low[2])},
            {Float8(box.high[0]), Float8(box.high[1]), Float8(box.high[2])}};
  }

  /// The vertices of a block, from the first column and row to the last.
  FieldRect vertices_of(const Block& block) const {
    const std::uint32_t columns = field_.levels.data()[block.level].columns;
    const std::uint32_t shift = kBlockShift + block.level;
    const std::uint32_t column = block.number % columns << shift;
    const std::uint32_t row = block.number / columns << shift;
    const std::uint32_t last_column = column + (1u << shift), last_row = row + (1u << shift);
    return {column, last_column < field_.columns() ? last_column : field_.columns() - 1, row,
            last_row < field_.rows() ? last_row : field_.rows() - 1};
  }

  FieldBox box_of(const Block& block) const {
    const FieldRect at = vertices_of(block);
    const HeightRange& heights = field_.levels.data()[block.level].blocks.data()[block.number];
    const float *x = field_.x.data(), *z = field_.z.data();
    return {{x[at.first_column], heights.low, z[at.first_row]},
            {x[at.last_column], heights.high, z[at.last_row]}};
  }

  bool is_within_reach(const Box8& a, const Box8& b) const {
    return ((squared_gap(a, b) <= Float8(reach_.squared_gap())).bits() & 1) != 0;
  }

  void look_first(const ClusterSlots& slots) {
    const TreePart part = {slots[0], slots[1]};
    if (part.node >= posed_.tree.nodes.size() || !is_cluster(posed_, part)) return;
    if (slots[2] >= field_.levels.data()[0].blocks.size()) return;
    open_node(posed_, part.node, work_);
    compare(part, slots[2]);
  }

  void visit(const TreePart& part, const Block& block) {
    const bool part_is_last = is_cluster(posed_, part), block_is_last = block.level == 0;
    if (part_is_last && block_is_last) return compare(part, block.number);
    const Box8 part_box = known_box(posed_, part), block_box = box8(box_of(block));
    if (!is_within_reach(part_box, block_box)) return;
    if (block_is_last || (!part_is_last && size(part_box) >= size(block_box))) {
      replace_part(part, block, block_box);
    } else {
      replace_block(part, part_box, block);
    }
  }

  /// Returns the sum of the horizontal sides.
  static float size(const Box8& box) {
    return (box.high[0] - box.low[0] + (box.high[2] - box.low[2])).low()[0];
  }

  void replace_part(const TreePart& part, const Block& block, const Box8& block_box) {
    ++work_.node_pairs;
    const std::uint32_t node = node_of(posed_, part);
    const OpenedNode& opened = open_node(posed_, node, work_);
    const Float8 gaps = squared_gaps(opened.low, opened.high, 0, block_box);
    const unsigned near = (gaps <= Float8(reach_.squared_gap())).bits();
    push_nearest_last(parts_, near & slots_of(posed_.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearParts{gap, node, slot, block.level, block.number};
                      });
  }

  void replace_block(const TreePart& part, const Box8& part_box, const Block& block) {
    ++work_.node_pairs;
    const FieldLevel& level = field_.levels.data()[block.level];
    const FieldLevel& below = field_.levels.data()[block.level - 1];
    const std::uint32_t column = 2 * (block.number % level.columns);
    const std::uint32_t row = 2 * (block.number / level.columns);
    std::uint32_t numbers[4], count = 0;
    FieldBoxes<8> boxes;
    boxes.clear();
    for (std::uint32_t r = row; r < row + 2 && r < below.rows; ++r)
      for (std::uint32_t c = column; c < column + 2 && c < below.columns; ++c) {
        numbers[count] = r * below.columns + c;
        const FieldBox box = box_of({block.level - 1, numbers[count]});
        for (int axis = 0; axis < 3; ++axis) {
          boxes.low[axis][count] = box.low[axis];
          boxes.high[axis][count] = box.high[axis];
        }
        ++count;
      }
    const Float8 gaps = squared_gaps(boxes.low, boxes.high, 0, part_box);
    const unsigned near = (gaps <= Float8(reach_.squared_gap())).bits();
    push_nearest_last(parts_, near & ((1u << count) - 1), gaps, [&](unsigned slot, float gap) {
      return NearParts{gap, part.node, part.slot, block.level - 1, numbers[slot]};
    });
  }

  /// Compares the triangles of a cluster with those of a block, nearest boxes first.
  void compare(const TreePart& part, std::uint32_t block) {
    const PosedCluster cluster = cluster_of(posed_, part);
    const TriangleBoxes& boxes = triangle_boxes(posed_, cluster.node, cluster.opened, cluster.slot);
    const Box8 block_box = box8(box_of({0, block}));
    alignas(32) float gaps[kMaxClusterTriangles];
    squared_gaps(boxes.low, boxes.high, 0, block_box).store(gaps);
    squared_gaps(boxes.low, boxes.high, 8, block_box).store(gaps + 8);
    const std::uint32_t count = cluster.cluster().triangle_count;
    BlockTriangles triangles;
    for (std::uint32_t i; (i = least_of(gaps, count, reach_.squared_gap())) < count;) {
      if (triangles.count() == 0) fill(block, triangles);
      gaps[i] = HUGE_VALF;
      compare(cluster, i, lane_box(boxes.low, boxes.high, i), triangles,
              {part.node, part.slot, block, 0});
    }
  }

  void fill(std::uint32_t block, BlockTriangles& triangles) const {
    const FieldRect at = vertices_of({0, block});
    const FieldRect cells = {at.first_column, at.last_column - 1, at.first_row, at.last_row - 1};
    const FieldBox everywhere = {{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF},
                                 {HUGE_VALF, HUGE_VALF, HUGE_VALF}};
    const auto add = [&](const FieldTriangle& triangle) { triangles.add(triangle); };
    FieldTriangles(field_, everywhere, cells, add).run();
  }

  void compare(const PosedCluster& cluster, std::uint32_t i, const Box8& box,
               const BlockTriangles& triangles, const ClusterSlots& slots) {
    alignas(32) float gaps[BlockTriangles::kMax];
    triangles.gaps_to(box, gaps);
    const std::uint32_t place = cluster.cluster().first_triangle + i;
    for (std::uint32_t k;
         (k = least_of(gaps, triangles.count(), reach_.squared_gap())) < triangles.count();) {
      gaps[k] = HUGE_VALF;
      measure(cluster, place, triangles[k], slots);
    }
  }

  void measure(const PosedCluster& cluster, std::uint32_t place, const FieldTriangle& other,
               const ClusterSlots& slots) {
    ++work_.triangle_pairs;
    TriangleGap gap;
    gap.corners_a = corners_of(cluster, place);
    for (std::size_t k = 0; k < 3; ++k)
      gap.corners_b[k] = {other.corners[k][0], other.corners[k][1], other.corners[k][2]};
    gap.closest = closest_points(gap.corners_a, gap.corners_b);
    gap.triangle_a = posed_.tree.triangle_ids.data()[place];
    gap.triangle_b = other.number;
    if (!goal_.wants(gap)) return;
    gap.slots = slots;
    goal_.take(gap);
    reach_.set(goal_.reach());
  }

  const PosedTree& posed_;
  const HeightField& field_;
  Stack<NearParts>& parts_;  // the top is visited next
  const SearchLimits& limits_;
  LeastGap goal_;
  Block top_;
  QueryStats work_;
  Reach reach_;
};

}  // namespace

QueryStats closest_field_triangle(const PosedTree& posed, const HeightField& field,
                                  Scratch& scratch, const SearchLimits& limits,
                                  TriangleGap& closest) {
  return FieldSearch(posed, field, scratch, limits, closest).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
