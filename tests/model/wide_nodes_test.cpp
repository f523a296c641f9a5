#include "model/tree_build.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pelt::detail {
namespace {

using test::Random;

/// A binary tree of random shape with this many clusters; areas decrease downwards.
ClusterTree random_tree(Random& random, std::uint32_t clusters) {
  ClusterTree tree;
  tree.nodes.push_back({.first = 0, .count = clusters, .left_child = 0, .area = 1});
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const ClusterTreeNode node = tree.nodes[n];
    if (node.count == 1) continue;
    const std::uint32_t left = 1 + random.index(node.count - 1);
    tree.nodes[n].left_child = static_cast<std::uint32_t>(tree.nodes.size());
    const auto area = [&] { return node.area * random.uniform(0.2, 1); };
    tree.nodes.push_back({node.first, left, 0, area()});
    tree.nodes.push_back({node.first + left, node.count - left, 0, area()});
  }
  return tree;
}

/// The number of slots below `n` if the nodes of `wide` are wide nodes.
std::uint32_t slots_below(const ClusterTree& tree, std::uint32_t n, const std::vector<bool>& wide) {
  const auto slots_of = [&](std::uint32_t child) {
    const bool is_slot = tree.nodes[child].is_cluster() || wide[child];
    return is_slot ? 1 : slots_below(tree, child, wide);
  };
  return slots_of(tree.nodes[n].left_child) + slots_of(tree.nodes[n].left_child + 1);
}

/// The least cost over every choice of wide nodes.
double least_cost(const ClusterTree& tree) {
  std::vector<std::uint32_t> inner;
  for (std::uint32_t n = 1; n < tree.nodes.size(); ++n)
    if (!tree.nodes[n].is_cluster()) inner.push_back(n);
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t choice = 0; choice < 1u << inner.size(); ++choice) {
    std::vector<bool> wide(tree.nodes.size(), false);
    wide[0] = true;
    for (std::size_t i = 0; i < inner.size(); ++i) wide[inner[i]] = choice >> i & 1;
    double cost = 0;
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
      if (!wide[n]) continue;
      const std::uint32_t slots = slots_below(tree, n, wide);
      if (slots > kMaxSlots) cost = std::numeric_limits<double>::infinity();
      cost += tree.nodes[n].area * (kNodeCost + slots);
    }
    least = std::min(least, cost);
  }
  return least;
}

std::uint32_t slot_count(const WideNode& node) {
  return std::uint32_t{node.cluster_count} + node.child_count;
}

/// Checks that every cluster and every wide node occurs once, in order. Returns the cost.
double expect_sound(const ClusterTree& tree, const std::vector<WideNode>& nodes) {
  std::vector<std::uint32_t> origins = {0};
  std::vector<bool> reached(tree.nodes.size(), false);
  double cost = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const WideNode& node = nodes[n];
    EXPECT_EQ(node.first_child, origins.size());
    EXPECT_GT(slot_count(node), 0u);
    EXPECT_LE(slot_count(node), kMaxSlots);
    for (std::uint32_t s = 0; s < slot_count(node); ++s) {
      EXPECT_EQ(tree.nodes[node.slots[s]].is_cluster(), s < node.cluster_count);
      EXPECT_FALSE(reached[node.slots[s]]);
      reached[node.slots[s]] = true;
      if (s >= node.cluster_count) origins.push_back(node.slots[s]);
    }
    cost += tree.nodes[origins[n]].area * (kNodeCost + slot_count(node));
  }
  EXPECT_EQ(origins.size(), nodes.size());
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    EXPECT_TRUE(reached[n] || !tree.nodes[n].is_cluster()) << n;
  return cost;
}

TEST(WideNodes, OneClusterHasOneNode) {
  Random random(77);
  const auto nodes = collapse(random_tree(random, 1));
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].cluster_count, 1);
  EXPECT_EQ(nodes[0].child_count, 0);
}

TEST(WideNodes, AreTheCheapestOfAllWays) {
  Random random(78);
  int one_node = 0, several = 0;
  for (int round = 0; round < 400; ++round) {
    const ClusterTree tree = random_tree(random, 2 + random.index(10));
    const auto nodes = collapse(tree);
    EXPECT_NEAR(expect_sound(tree, nodes), least_cost(tree), 1e-9);
    ++(nodes.size() == 1 ? one_node : several);
  }
  EXPECT_GT(one_node, 50);
  EXPECT_GT(several, 50);
}

TEST(WideNodes, ReachEveryClusterOfALargeTree) {
  Random random(79);
  for (std::uint32_t clusters : {9u, 100u, 3000u}) {
    const ClusterTree tree = random_tree(random, clusters);
    const auto nodes = collapse(tree);
    expect_sound(tree, nodes);
    EXPECT_LT(nodes.size(), clusters);
    EXPECT_TRUE(std::any_of(nodes.begin(), nodes.end(), [](const WideNode& node) {
      return node.cluster_count > 0 && node.child_count > 0;
    })) << "clusters first, and children after them";
  }
}

TEST(WideNodes, WithoutAreaNodesAreFull) {
  Random random(80);
  ClusterTree tree = random_tree(random, 64);
  for (ClusterTreeNode& node : tree.nodes) node.area = 0;
  const auto nodes = collapse(tree);
  expect_sound(tree, nodes);
  EXPECT_EQ(slot_count(nodes[0]), kMaxSlots);
}

}  // namespace
}  // namespace pelt::detail
