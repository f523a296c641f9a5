#pragma once

/// Finds the touching triangles of two clusters whose boxes overlap. Triangles outside of the
/// intersection of the two boxes are skipped. The boxes of the others are tested one against
/// sixteen. The remaining pairs wait until there are eight for the certified float test
/// (triangle_triage.hpp). The exact predicate decides the few lanes that this test leaves
/// undecided.

#include <pelt/collide.hpp>

#include "base/instruction_set.hpp"
#include "collide/row_lanes.hpp"
#include "query/slots.hpp"
#include "query/stack.hpp"
#include "query/triangle_batch.hpp"

#include <cstdint>

namespace pelt::detail {

inline namespace PELT_INSTRUCTION_SET {

class TrianglePairs {
 public:
  TrianglePairs(const Tree& tree_a, const Tree& tree_b, Stack<Contact>& contacts, QueryStats& work)
      : a_(tree_a), b_(tree_b), contacts_(contacts), work_(work) {}

  /// Tests all triangles of two clusters whose boxes overlap, or stores them for the next test.
  void add(const PosedCluster& a, const PosedCluster& b);

  /// Tests these pairs of triangles, or stores them: rows are triangles of `a`, lanes triangles of
  /// `b`.
  void add(const PosedCluster& a, const PosedCluster& b, const RowLanes& pairs) {
    keep(pairs, a, a_, b, b_);
    test_full_batches();
  }

  /// Tests the stored pairs.
  void flush();

  /// Number of stored pairs.
  std::uint32_t waiting() const { return count_; }

 private:
  static constexpr std::uint32_t kRoom = kBatch + kMaxClusterTriangles * kMaxClusterTriangles;

  /// Triangles of one side of the waiting pairs.
  struct Side {
    explicit Side(const Tree& t) : tree(t) {}

    const float* corner(std::uint32_t i, std::size_t k) const {
      return positions[i] + tree.corners[triangle[i]][k];
    }
    TriangleCorners corners(std::uint32_t i) const;
    void corners8(std::uint32_t first, Points8 (&corners)[3]) const;
    std::uint32_t id(std::uint32_t i) const { return tree.triangle_ids[triangle[i]]; }

    void copy(std::uint32_t from, std::uint32_t to) {
      triangle[to] = triangle[from];
      positions[to] = positions[from];
    }

    const Tree& tree;
    std::uint32_t triangle[kRoom];  ///< into Tree::corners
    const float* positions[kRoom];  ///< posed pool of the triangle
  };

  void keep(const RowLanes& pairs, const PosedCluster& row_cluster, Side& rows,
            const PosedCluster& lane_cluster, Side& lanes);
  void test_full_batches();
  void test(std::uint32_t first, std::uint32_t count);
  void report(std::uint32_t i) { contacts_.push(Contact{a_.id(i), b_.id(i)}); }

  Side a_, b_;
  std::uint32_t count_ = 0;
  Stack<Contact>& contacts_;
  QueryStats& work_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
