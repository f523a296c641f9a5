/// The box of the whole skin takes six descents, one per side. Each visits the child that reaches
/// farthest first, and other children only if they reach beyond the result so far. Nodes that one
/// descent opens stay open for the next.
///
/// A posed vertex is a convex combination of its images under single joints, and each image is in
/// the moved rest box of its joint. Its distance from a point is therefore at most that of the
/// farthest vertex of these boxes (node_bounds.hpp has the rounding of the boxes). The vertex of a
/// box with centre p and half extents h that is farthest from c has the distances |p - c| + h along
/// the axes.
///
/// Rounding. With six roundings on each axis, including that of the margin, five for squares and
/// sums, and one for the root, the error is at most 13 u of the radius, where u = 2^-24; the radius
/// is increased by 16 u. A square that underflows has an error of at most 2^-149, far below 2^-100.
/// A square that overflows makes the radius infinite, which is still a bound.
///
/// Offsets. A posed vertex is then a convex combination of its images, each moved by the same
/// offset of at most c on each axis, so the boxes grow by c. The sum of vertex and offset has one
/// more rounding, of at most u (M + c).

#include "bounds/bounds_search.hpp"
#include "base/float8.hpp"
#include "model/node_box.hpp"
#include "pose/open_node.hpp"
#include "query/slots.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

enum class Side { low, high };

/// Coordinate of the slots of a node on one side of the box.
using Reach = float[kMaxSlots];

/// Slots of a node, in descending order of reach.
class FarthestFirst {
 public:
  FarthestFirst(const Reach& reach, unsigned slots) : reach_(reach), left_(slots) {}

  explicit operator bool() const { return left_ != 0; }

  /// Returns the next slot. Precondition: there is one.
  unsigned next() {
    SetBits slot(left_);
    unsigned farthest = *slot;
    for (++slot; slot; ++slot)
      if (reach_[*slot] > reach_[farthest]) farthest = *slot;
    left_ &= ~(1u << farthest);
    return farthest;
  }

 private:
  const Reach& reach_;
  unsigned left_;
};

class BoundingBox {
 public:
  BoundingBox(const PosedTree& posed, QueryStats& work) : posed_(posed), work_(work) {}

  /// Precondition: `levels` is not zero, and there is a table of opened nodes.
  Box4 run(std::uint32_t levels) {
    float low[4] = {}, high[4] = {};
    for (axis_ = 0; axis_ < 3; ++axis_) {
      high[axis_] = farthest<Side::high>(levels);
      low[axis_] = -farthest<Side::low>(levels);
    }
    return {load4(low), load4(high)};
  }

 private:
  template <Side kSide>
  float farthest(std::uint32_t levels) {
    farthest_ = -HUGE_VALF;
    descend<kSide>(0, levels);
    return farthest_;
  }

  /// Moves `farthest_` to the reach of the vertices below a node, or to its bound after the given
  /// number of levels.
  template <Side kSide>
  void descend(std::uint32_t index, std::uint32_t levels) {
    ++work_.node_pairs;
    const OpenedNode& opened = open_node(posed_, index, work_);
    const Node& node = posed_.tree.nodes[index];
    const Float8 sides =
        kSide == Side::high ? load8(opened.high[axis_]) : Float8(0.0f) - load8(opened.low[axis_]);
    const unsigned beyond = (Float8(farthest_) < sides).bits();
    const unsigned known = levels > 1 ? clusters_of(node) : kAllSlots;
    Reach reach;
    sides.store(reach);
    for (SetBits slot(beyond & known); slot; ++slot)
      farthest_ = reach[*slot] > farthest_ ? reach[*slot] : farthest_;
    for (FarthestFirst slots(reach, beyond & ~known); slots;) {
      const unsigned slot = slots.next();
      if (reach[slot] <= farthest_) return;
      descend<kSide>(child(node, slot), levels - 1);
    }
  }

  const PosedTree& posed_;
  QueryStats& work_;
  int axis_ = 0;
  float farthest_ = 0;
};

/// Makes zeros positive.
BoxFound store(const Box4& box) {
  BoxFound stored;
  store4(stored.low, box.low + Float4(0.0f));
  store4(stored.high, box.high + Float4(0.0f));
  return stored;
}

}  // namespace

BoxFound bounding_box(const PosedTree& posed, std::uint32_t levels) {
  QueryStats work;
  const RootBox& root = root_box(posed, work);
  Box4 box = {load4(root.low), load4(root.high)};
  if (levels > 0) {
    make_table(posed);
    box = intersect(box, BoundingBox(posed, work).run(levels));
  }
  BoxFound found = store(box);
  found.work = work;
  return found;
}

BoxFound bound_of_set(const NodeBounds& bounds, std::uint32_t set, const Palette& palette) {
  BoxFound found = store(node_box(bounds, set, palette));
  found.work.refits = 1;
  return found;
}

BoxFound box_given(const GivenVertices& given, std::span<const std::uint32_t> places) {
  Box4 box = empty_box();
  for (const std::uint32_t place : places) {
    const Float4 p = load4(given.at(place));
    box = unite(box, {p, p});
  }
  BoxFound found = store(box);
  found.work.refits = 1;
  return found;
}

BoxFound box_places(const Tree& tree, const Palette& palette,
                    std::span<const std::uint32_t> places) {
  std::uint64_t displacements = 0;
  BoxFound found = store(box_vertices(tree, palette, places, displacements));
  found.work.refits = 1;
  found.work.displacements = displacements;
  found.work.posed_vertices = places.size();
  return found;
}

namespace {

/// Returns an upper bound of how far dual quaternion skinning moves a vertex away from where linear
/// blend skinning moves it.
float longest_shift(const NodeBounds& bounds, const Palette& palette) {
  const DualShift shift = dual_shift(bounds, 0, palette, Float4(0.0f));
  float squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float below = shift.down_up.low()[axis], above = shift.down_up.high()[axis];
    const float most = (below > above ? below : above) + shift.margin;
    squared += most * most;
  }
  return std::sqrt(squared + 0x1p-100f) * (1 + 0x1p-20f);
}

}  // namespace

float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre) {
  const NodeBound& root = bounds.nodes[0];
  if (root.is_affine()) return HUGE_VALF;
  const std::uint16_t* joint = bounds.joints.data() + root.first_joint;
  const JointBox* box = bounds.joint_boxes.data() + root.first_record;
  const float cap = palette.offsets().empty() ? 0 : bounds.offset_caps[0];
  const Float4 from = load4(centre);
  const Float4 margin((root.margin + (cap > 0 ? 0x1p-23f : 0)) * palette.extent() +
                      cap * (1 + 0x1p-21f) + 0x1p-120f);
  float farthest = 0;
  const bool morphed = palette.morphs().any();
  for (std::uint32_t i = 0; i < root.joint_count; ++i, ++joint, ++box) {
    const ColumnPairs c = load_columns(palette[*joint]);
    const MorphedJointBox moved =
        morphed ? morphed_joint_box(bounds, root, i, palette) : MorphedJointBox{};
    const JointBox& rest = morphed ? moved.box : *box;
    const Float4 middle = fold(image(c, rest.centre));
    const Float4 half = fold(image(magnitudes(c), rest.half));
    const Float4 reach = morphed ? half + margin + moved.margin : half + margin;
    const Float4 away = abs(middle - from) + reach, squares = away * away;
    const float distance = squares[0] + squares[1] + squares[2];
    farthest = distance > farthest ? distance : farthest;
  }
  const float radius = std::sqrt(farthest + 0x1p-100f) * (1 + 0x1p-20f);
  return palette.is_dual() ? radius + longest_shift(bounds, palette) : radius;
}

namespace {

// The farthest vertex along d, by branch and bound. No point of a box with bounds l and h is
// farther along d than the sum of max(d_a l_a, d_a h_a) over the axes a. Boxes below the best
// vertex so far are skipped, and the slot with the greatest bound is visited first.
//
// Rounding. d is the direction times a power of two, so that its largest component is in [1, 2). A
// component that underflows has an error below 2^-149, times 2^60 for a coordinate. Values along d
// have four roundings of 2^-24 on terms whose sum is at most `size`, so their error is at most
// 2^-21 size + 2^-80. Vertices that this does not distinguish are compared exactly.

class FarthestSearch {
 public:
  FarthestSearch(const PosedTree& posed, const Vec3& direction, FarthestVertex& best)
      : posed_(posed), direction_(direction), scaled_(scaled_direction(direction)), best_(best) {}

  QueryStats run() {
    make_table(posed_);
    visit(0);
    return work_;
  }

 private:
  void visit(std::uint32_t index) {
    ++work_.node_pairs;
    const Node& node = posed_.tree.nodes.data()[index];
    const OpenedNode& opened = open_node(posed_, index, work_);
    alignas(32) float bounds[kMaxSlots];
    bound(opened).store(bounds);
    for (unsigned slots = slots_of(node); slots != 0;) {
      unsigned next = *SetBits(slots);
      for (SetBits slot(slots); slot; ++slot)
        if (bounds[*slot] > bounds[next]) next = *slot;
      if (bounds[next] < reached_) return;
      slots &= ~(1u << next);
      if (next < node.cluster_count) {
        compare({posed_, node, opened, next});
      } else {
        visit(child(node, next));
      }
    }
  }

  /// Upper bounds of the slots' positions along the direction.
  Float8 bound(const OpenedNode& opened) const {
    const float d[3] = {scaled_.x, scaled_.y, scaled_.z};
    Float8 sum(0.0f), size(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const Float8 low = load8(opened.low[axis]), high = load8(opened.high[axis]);
      const Float8 along(d[axis]);
      sum = sum + max(along * low, along * high);
      size = size + abs(along) * max(abs(low), abs(high));
    }
    return sum + (size * Float8(0x1p-21f) + Float8(0x1p-80f));
  }

  void compare(const PosedCluster& cluster) {
    work_.triangle_pairs += cluster.cluster().triangle_count;
    for (std::uint32_t i = 0; i < cluster.cluster().triangle_count; ++i) {
      const std::uint32_t place = cluster.cluster().first_triangle + i;
      for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const float* at = cluster.opened.positions + posed_.tree.corners.data()[place][corner];
        consider(posed_.tree.triangle_ids.data()[place], corner, {at[0], at[1], at[2]});
      }
    }
  }

  void consider(std::uint32_t triangle, std::uint32_t corner, const Vec3& p) {
    const float x = scaled_.x * p.x, y = scaled_.y * p.y, z = scaled_.z * p.z;
    const float along = x + y + z;
    const float error = (std::fabs(x) + std::fabs(y) + std::fabs(z)) * 0x1p-21f + 0x1p-80f;
    if (along + error < reached_) return;
    if (best_ && !is_better(triangle, corner, p)) return;
    best_ = {triangle, corner, p};
    reached_ = along - error;
  }

  bool is_better(std::uint32_t triangle, std::uint32_t corner, const Vec3& position) const {
    const int sign = compare_along(direction_, position, best_.position);
    if (sign != 0) return sign > 0;
    if (triangle != best_.triangle) return triangle < best_.triangle;
    return corner < best_.corner;
  }

  const PosedTree& posed_;
  const Vec3 direction_;
  const Vec3 scaled_;
  QueryStats work_;
  FarthestVertex& best_;
  float reached_ = -HUGE_VALF;  // lower bound of the best vertex's position
};

}  // namespace

QueryStats find_farthest(const PosedTree& posed, const Vec3& direction, FarthestVertex& farthest) {
  farthest = {};
  return FarthestSearch(posed, direction, farthest).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
