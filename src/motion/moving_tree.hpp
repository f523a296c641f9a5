#pragma once

/// View of a step for queries: one tree in two poses. A node is opened in both.

#include "pose/open_node.hpp"
#include "query/slots.hpp"

namespace pelt::detail {

struct MovingTree {
  MovingTree(const PosedTree& f, const PosedTree& t) : tree(f.tree), from(f), to(t) {}

  const Tree& tree;
  const PosedTree &from, &to;
};

struct MovingNode {
  const OpenedNode &from, &to;
};

struct MovingCluster {
  const MovingTree& moving;
  const Node& node;
  MovingNode opened;
  std::uint32_t slot;

  const Cluster& cluster() const { return moving.tree.clusters[node.first_cluster + slot]; }
};

inline namespace PELT_INSTRUCTION_SET {

inline MovingNode open_node(const MovingTree& moving, std::uint32_t node, QueryStats& work) {
  return {open_node(moving.from, node, work), open_node(moving.to, node, work)};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
