#pragma once

/// Pairs of a moving triangle and a triangle of a height field that wait for the test of
/// motion/moving_triangles.hpp.

#include "field/field_cells.hpp"
#include "motion/moving_polynomials.hpp"
#include "motion/moving_tree.hpp"
#include "motion/moving_triage.hpp"
#include "query/triangle_batch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

class MovingFieldPairs {
 public:
  explicit MovingFieldPairs(const Tree& tree) : tree_(tree) {}

  /// Adds triangle `number` of a cluster and one of the field. Precondition: there are fewer than
  /// eight pairs.
  void add(const MovingCluster& cluster, unsigned number, const FieldTriangle& field) {
    waiting_.add({cluster.cluster().first_triangle + number, cluster.opened.from.positions,
                  cluster.opened.to.positions, field});
  }

  bool is_full() const { return waiting_.is_full(); }
  std::uint32_t count() const { return waiting_.count(); }
  void clear() { waiting_.clear(); }

  MovingPairs8 corners8() {
    waiting_.pad();
    MovingPairs8 pairs;
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.from.a[k] = gather_points([&](std::uint32_t i) { return corner(i, &Pair::from, k); });
      pairs.to.a[k] = gather_points([&](std::uint32_t i) { return corner(i, &Pair::to, k); });
      pairs.from.b[k] =
          gather_points([&](std::uint32_t i) { return waiting_[i].field.corners[k]; });
      pairs.to.b[k] = pairs.from.b[k];
    }
    return pairs;
  }

  Contact contact(unsigned lane) const {
    return {tree_.triangle_ids[waiting_[lane].triangle], waiting_[lane].field.number};
  }

  MovingTriangle triangle_a(unsigned lane) const {
    return {corners_at([&](std::size_t k) { return corner(lane, &Pair::from, k); }),
            corners_at([&](std::size_t k) { return corner(lane, &Pair::to, k); })};
  }

  /// Stands still.
  MovingTriangle triangle_b(unsigned lane) const {
    const TriangleCorners corners =
        corners_at([&](std::size_t k) { return waiting_[lane].field.corners[k]; });
    return {corners, corners};
  }

 private:
  struct Pair {
    std::uint32_t triangle;  ///< into Tree::corners
    const float *from, *to;  ///< its posed pools
    FieldTriangle field;
  };

  const float* corner(std::uint32_t lane, const float* Pair::*end, std::size_t k) const {
    const Pair& pair = waiting_[lane];
    return pair.*end + tree_.corners[pair.triangle][k];
  }

  const Tree& tree_;
  Batch8<Pair> waiting_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
