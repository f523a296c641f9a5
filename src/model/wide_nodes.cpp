#include "model/wide_nodes.hpp"

#include <algorithm>
#include <limits>

namespace pelt::detail {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The best distribution of a subtree over k slots of a node, for each k. With k = 1 the slot is a
/// cluster, at no cost, or a wide node of its own. For a subtree with children l and r:
///
///     cost[k] = min over 1 <= i < k of  l.cost[i] + r.cost[k - i]       for k > 1
///     cost[1] = min over k > 1 of       cost[k] + area (kNodeCost + k)
struct Spread {
  std::array<double, kMaxSlots + 1> cost;          ///< of the wide nodes in the subtree
  std::array<std::uint8_t, kMaxSlots + 1> left{};  ///< how many of the slots go to the left child
  std::uint8_t slots = 0;                          ///< slots of the subtree's own wide node
};

Spread spread_of_cluster() {
  Spread spread;
  spread.cost.fill(kNever);
  spread.cost[1] = 0;
  return spread;
}

/// Computes the distribution of a subtree from those of its children.
Spread spread_over(const Spread& left, const Spread& right, double area) {
  Spread spread = spread_of_cluster();
  spread.cost[1] = kNever;
  for (std::uint32_t k = 2; k <= kMaxSlots; ++k)
    for (std::uint32_t l = 1; l < k; ++l) {
      const double cost = left.cost[l] + right.cost[k - l];
      if (cost < spread.cost[k])
        spread.cost[k] = cost, spread.left[k] = static_cast<std::uint8_t>(l);
    }
  for (std::uint32_t k = 2; k <= kMaxSlots; ++k) {
    const double cost = spread.cost[k] + area * (kNodeCost + k);
    if (cost <= spread.cost[1]) spread.cost[1] = cost, spread.slots = static_cast<std::uint8_t>(k);
  }
  return spread;
}

std::vector<Spread> spread_all(const ClusterTree& tree) {
  std::vector<Spread> spreads(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const ClusterTreeNode& node = tree.nodes[n];
    spreads[n] = node.is_cluster() ? spread_of_cluster()
                                   : spread_over(spreads[node.left_child],
                                                 spreads[node.left_child + 1], node.area);
  }
  return spreads;
}

class Collapse {
 public:
  explicit Collapse(const ClusterTree& tree) : tree_(tree), spreads_(spread_all(tree)) {}

  std::vector<WideNode> run() && {
    std::vector<std::uint32_t> origins = {0};  // by wide node: its node in the cluster tree
    for (std::size_t n = 0; n < origins.size(); ++n) {
      WideNode node = make_node(origins[n]);
      node.first_child = static_cast<std::uint32_t>(origins.size());
      const auto children = node.slots.begin() + node.cluster_count;
      origins.insert(origins.end(), children, children + node.child_count);
      nodes_.push_back(node);
    }
    return std::move(nodes_);
  }

 private:
  bool is_cluster(std::uint32_t n) const { return tree_.nodes[n].is_cluster(); }

  WideNode make_node(std::uint32_t origin) const {
    WideNode node;
    std::vector<std::uint32_t> slots;
    if (is_cluster(origin))
      slots = {origin};  // the whole mesh is a single cluster
    else
      spread(origin, spreads_[origin].slots, slots);
    const auto middle = std::stable_partition(slots.begin(), slots.end(),
                                              [&](std::uint32_t n) { return is_cluster(n); });
    std::copy(slots.begin(), slots.end(), node.slots.begin());
    node.cluster_count = static_cast<std::uint8_t>(middle - slots.begin());
    node.child_count = static_cast<std::uint8_t>(slots.end() - middle);
    return node;
  }

  /// Appends the `k` slots of the subtree `origin`.
  void spread(std::uint32_t origin, std::uint32_t k, std::vector<std::uint32_t>& slots) const {
    if (k == 1) {
      slots.push_back(origin);
      return;
    }
    const std::uint32_t left = spreads_[origin].left[k];
    spread(tree_.nodes[origin].left_child, left, slots);
    spread(tree_.nodes[origin].left_child + 1, k - left, slots);
  }

  const ClusterTree& tree_;
  std::vector<Spread> spreads_;
  std::vector<WideNode> nodes_;
};

}  // namespace

std::vector<WideNode> collapse(const ClusterTree& tree) { return Collapse(tree).run(); }

}  // namespace pelt::detail
