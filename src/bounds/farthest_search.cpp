/// Branch and bound. No point of a box with bounds l and h is farther along d than the sum of
/// max(d_a l_a, d_a h_a) over the axes a. Boxes below the best vertex so far are skipped, and the
/// slot with the greatest bound is visited first.
///
/// Rounding. d is the direction times a power of two, so that its largest component is in [1, 2). A
/// component that underflows has an error below 2^-149, times 2^60 for a coordinate. Values along d
/// have four roundings of 2^-24 on terms whose sum is at most `size`, so their error is at most
/// 2^-21 size + 2^-80. Vertices that this does not distinguish are compared exactly.

#include "bounds/farthest_search.hpp"
#include "base/float8.hpp"
#include "pose/open_node.hpp"
#include "query/slots.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

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
