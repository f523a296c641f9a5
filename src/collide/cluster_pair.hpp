#pragma once

/// Two clusters whose boxes overlap: which of their triangles touch. Triangles that leave the
/// intersection of the two boxes cannot; the boxes of the others are tested one against sixteen;
/// what is left waits until there are eight pairs for the certified float test
/// (triangle_triage.hpp). The few lanes that it leaves undecided go to the exact predicate.

#include <pelt/collide.hpp>

#include "base/target.hpp"
#include "collide/row_lanes.hpp"
#include "query/slots.hpp"
#include "query/stack.hpp"
#include "query/triangle_batch.hpp"

#include <cstdint>

namespace pelt::detail {

inline namespace PELT_TARGET {

class TrianglePairs {
 public:
  TrianglePairs(const Tree& tree_a, const Tree& tree_b, Stack<Contact>& contacts, QueryStats& work)
      : a_(tree_a), b_(tree_b), contacts_(contacts), work_(work) {}

  /// Tests, or keeps for the next test, all triangles of two clusters whose boxes overlap.
  void add(const PosedCluster& a, const PosedCluster& b);

  /// Tests what was kept.
  void flush();

 private:
  static constexpr std::uint32_t kRoom = kBatch + kMaxClusterTriangles * kMaxClusterTriangles;

  /// The triangles of one side of the pairs that wait.
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
    const float* positions[kRoom];  ///< of the pool that its corners lie in
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

}  // namespace PELT_TARGET
}  // namespace pelt::detail
