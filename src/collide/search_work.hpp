#pragma once

/// How much work a search has done, and which nodes it has needed.

#include <pelt/search.hpp>

#include "pose/pool_vertices.hpp"
#include "pose/posed_tree.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelt::detail {

/// Work of a search, in units.
struct SearchWork {
  std::uint64_t granted = 0, done = 0, longest_step = 0;

  bool is_left() const { return done < granted; }

  /// The work of starting counts as granted.
  void start(std::uint64_t work) {
    granted = done = work;
    longest_step = 0;
  }

  void grant(std::uint64_t work) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    granted = work <= kMost - granted ? granted + work : kMost;
  }

  /// `total`: work of all steps so far.
  void end_step(std::uint64_t total) {
    longest_step = std::max(longest_step, total - done);
    done = total;
  }
};

// The nodes that a search has needed. A node counts as work when the search needs it first,
// whether another query has opened it or not, so partial answers do not depend on other queries.

/// One bit for each node of a tree.
using NodeSet = std::vector<std::uint64_t>;

inline namespace PELT_INSTRUCTION_SET {

inline void clear_needed(NodeSet& needed, const Tree& tree) {
  needed.assign((tree.nodes.size() + 63) / 64, 0);
}

inline std::uint64_t work_to_open(const PosedTree& posed, std::uint32_t index) {
  const Node& node = posed.tree.nodes[index];
  QueryStats work;
  work.refits = node.cluster_count + node.child_count;
  if (posed.given) return kRefitWork * work.refits;
  work.posed_vertices = node.vertex_count;
  if (posed.palette.morphs().any())
    work.displacements = displacement_count(posed.tree, index, posed.palette.morphs());
  return kRefitWork * work.refits + kPosedVertexWork * work.posed_vertices +
         kDisplacementWork * work.displacements;
}

inline bool is_needed(const NodeSet& needed, std::uint32_t node) {
  return (needed[node / 64] >> node % 64 & 1) != 0;
}

/// Adds a node. Returns the work of opening it, or 0 if the search has needed it before.
inline std::uint64_t work_to_need(const PosedTree& posed, std::uint32_t index, NodeSet& needed) {
  std::uint64_t& word = needed[index / 64];
  const std::uint64_t bit = std::uint64_t{1} << index % 64;
  if ((word & bit) != 0) return 0;
  word |= bit;
  return work_to_open(posed, index);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
