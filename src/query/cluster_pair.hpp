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
};

/// Where one triangle of an opened node is found.
struct PosedTriangle {
  const float* positions;        ///< of the node's pool
  const std::uint16_t* corners;  ///< three offsets in it
  const std::uint32_t* id;       ///< the caller's number

  const float* corner(int i) const { return positions + corners[i]; }
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
  void keep(const PosedTriangle& a, const PosedTriangle& b) {
    kept_a_[kept_count_] = a;
    kept_b_[kept_count_] = b;
    if (++kept_count_ == 8) flush();
  }

  void report(unsigned lane) { contacts_.push(Contact{*kept_a_[lane].id, *kept_b_[lane].id}); }

  Stack<Contact>& contacts_;
  QueryStats& work_;
  PosedTriangle kept_a_[8], kept_b_[8];
  std::uint32_t kept_count_ = 0;
};

}  // namespace PELT_TARGET
}  // namespace pelt::detail
