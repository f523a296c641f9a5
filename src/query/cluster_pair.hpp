#pragma once

/// Two clusters whose boxes overlap: which of their triangles touch. Triangles that leave the
/// intersection of the two boxes cannot; the boxes of the others are tested one against eight; what
/// is left waits until there are eight pairs for the certified float test (triangle_triage.hpp).
/// The few lanes that it leaves undecided go to the exact predicate.

#include "base/stack.hpp"
#include "base/target.hpp"
#include "pose/posed_tree.hpp"

#include <cstdint>

namespace pelt::detail {

/// One cluster of an opened node.
struct PosedCluster {
  const PosedTree& posed;
  const Node& node;
  const OpenedNode& opened;
  std::uint32_t slot;

  const Cluster& cluster() const { return posed.tree.clusters[node.first_cluster + slot]; }
};

inline namespace PELT_TARGET {

class TrianglePairs {
 public:
  TrianglePairs(Stack<Contact>& contacts, QueryStats& work) : contacts_(contacts), work_(work) {}

  /// Tests, or keeps for the next test, all triangles of two clusters whose boxes overlap.
  void add(const PosedCluster& a, const PosedCluster& b);

  /// Tests what was kept.
  void flush();

 private:
  struct Candidate {
    const float* a[3];
    const float* b[3];
    Contact ids;
  };

  void keep(const PosedCluster& a, std::uint32_t triangle_a, const PosedCluster& b,
            std::uint32_t triangle_b);

  Stack<Contact>& contacts_;
  QueryStats& work_;
  Candidate kept_[8];
  std::uint32_t kept_count_ = 0;
};

}  // namespace PELT_TARGET
}  // namespace pelt::detail
