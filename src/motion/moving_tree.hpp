#pragma once

/// View of a step for queries: one tree in two poses. A node is opened in both.

#include <pelt/motion.hpp>

#include "pose/open_node.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/slots.hpp"

namespace pelt::detail {

struct MovingTree {
  MovingTree(const PosedTree& f, const PosedTree& t) : tree(f.tree), from(f), to(t) {}

  const Tree& tree;
  const PosedTree &from, &to;
};

inline void make_table(const MovingTree& moving) {
  make_table(moving.from);
  make_table(moving.to);
}

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

/// Precondition: the node is open at both ends.
inline MovingNode opened_node(const MovingTree& moving, std::uint32_t node) {
  return {*moving.from.opened[node], *moving.to.opened[node]};
}

inline namespace PELT_INSTRUCTION_SET {

inline MovingNode open_node(const MovingTree& moving, std::uint32_t node, QueryStats& work) {
  return {open_node(moving.from, node, work), open_node(moving.to, node, work)};
}

}  // namespace PELT_INSTRUCTION_SET

/// Views of both poses of a step.
struct Step {
  MovingTree tree() const { return {from, to}; }

  PosedTree from, to;
};

/// Aborts unless both poses of the motion are of one model.
Step step_of(const Motion& motion);

/// Aborts unless both motions are of one model each and have no pose in common.
void require_steps(const Motion& a, const Motion& b);

/// Whether things touch at some time. `find(options)` writes at most one contact to
/// `scratch.moving`.
template <typename Find>
YesNo touches_while_moving(const Scratch& scratch, const Find& find) {
  MovingOptions options;
  options.times = false;
  options.max_contacts = 1;
  const MovingStats stats = find(options);
  return yes_or_no(!scratch.moving.empty(), stats);
}

}  // namespace pelt::detail
