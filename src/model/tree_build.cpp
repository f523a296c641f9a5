#include "model/tree_build.hpp"

#include "base/assert.hpp"
#include "model/bound_fit.hpp"
#include "model/clusters.hpp"
#include "model/triangle_places.hpp"
#include "model/weld.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace pelt::detail {
namespace {

// The nodes, from the binary tree of clusters.

constexpr double kInfinite = std::numeric_limits<double>::infinity();

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
  spread.cost.fill(kInfinite);
  spread.cost[1] = 0;
  return spread;
}

/// Computes the distribution of a subtree from those of its children.
Spread spread_over(const Spread& left, const Spread& right, double area) {
  Spread spread = spread_of_cluster();
  spread.cost[1] = kInfinite;
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

namespace {

// The arrays of the tree, from the nodes.

constexpr std::uint32_t kNowhere = 0xFFFFFFFF;

std::uint32_t size32(std::size_t size) {
  PELT_ASSERT(size < kNowhere);
  return static_cast<std::uint32_t>(size);
}

/// Returns for each vertex [V] the vertex that the tree stores for it.
std::vector<std::uint32_t> merged_vertices(const SkinnedMesh& mesh) {
  std::vector<std::uint32_t> merged(mesh.vertex_count());
  std::iota(merged.begin(), merged.end(), 0u);
  if (!mesh.may_weld) return merged;
  const std::vector<std::uint32_t> welded = weld_vertices(mesh);
  for (std::size_t v = 0; v < merged.size(); ++v)
    if (mesh.offset_caps.empty() || mesh.offset_caps[v] == 0) merged[v] = welded[v];
  return merged;
}

/// Writes the arrays of a tree, node by node.
class TreeWriter {
 public:
  TreeWriter(const SkinnedMesh& mesh, const ClusterTree& clusters)
      : mesh_(mesh),
        clusters_(clusters),
        welded_(merged_vertices(mesh)),
        last_node_(mesh.vertex_count(), kNowhere),
        places_(mesh.vertex_count(), kNowhere) {
    tree_.joint_count = mesh.joint_count;
    tree_.rest_extent = mesh.rest_extent;
    tree_.dual_influences = mesh.dual_influences;
    tree_.influence_begin.push_back(0);
    tree_.morphs.extents = mesh.morph_extents;
  }

  Tree write(const std::vector<WideNode>& nodes) && {
    for (const WideNode& node : nodes) write_node(node);
    write_vertex_places();
    if (tree_.dual_influences > 0) tree_.links = find_joint_links(tree_);
    shrink();
    return std::move(tree_);
  }

 private:
  void write_node(const WideNode& wide) {
    const std::span slots(wide.slots.data(), wide.cluster_count);
    fill_pool(slots);
    Node node;
    node.first_vertex = size32(tree_.rest_positions.size());
    node.first_cluster = size32(tree_.clusters.size());
    node.first_child = wide.first_child;
    node.vertex_count = static_cast<std::uint16_t>(pool_.size());
    node.cluster_count = wide.cluster_count;
    node.child_count = wide.child_count;
    for (const std::uint32_t v : pool_) write_vertex(v);
    write_displacements();
    for (const std::uint32_t slot : slots) write_cluster(slot, node.first_vertex);
    tree_.nodes.push_back(node);
  }

  std::span<const std::uint32_t> triangles_of(std::uint32_t cluster) const {
    const ClusterTreeNode& node = clusters_.nodes[cluster];
    return {clusters_.triangle_order.data() + node.first, node.count};
  }

  /// Collects the distinct welded vertices of these clusters, ordered by number of influences.
  void fill_pool(std::span<const std::uint32_t> clusters) {
    const std::uint32_t this_node = size32(tree_.nodes.size());
    pool_.clear();
    for (const std::uint32_t cluster : clusters)
      for (const std::uint32_t t : triangles_of(cluster))
        for (const std::uint32_t corner : mesh_.triangles[t]) {
          const std::uint32_t v = welded_[corner];
          if (std::exchange(last_node_[v], this_node) != this_node) pool_.push_back(v);
        }
    std::stable_sort(pool_.begin(), pool_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.influences_of(a).size() < mesh_.influences_of(b).size();
    });
  }

  void write_vertex(std::uint32_t v) {
    places_[v] = size32(tree_.rest_positions.size());
    tree_.rest_positions.push_back(mesh_.rest_positions[v]);
    tree_.place_vertices.push_back(v);
    if (!mesh_.offset_caps.empty()) tree_.offset_caps.push_back(mesh_.offset_caps[v]);
    for (const Influence& influence : mesh_.influences_of(v)) {
      tree_.joints.push_back(static_cast<std::uint16_t>(influence.joint));
      tree_.weights.push_back(influence.weight);
    }
    tree_.influence_begin.push_back(size32(tree_.joints.size()));
    for (const Displacement& displacement : mesh_.displacements_of(v))
      displaced_.push_back({displacement.target, {displacement.by, places_[v]}});
  }

  /// Writes the displacements of the vertices written since the last call, sorted by target.
  void write_displacements() {
    PoolMorphs& morphs = tree_.morphs;
    if (morphs.extents.empty()) return;
    if (morphs.node_begin.empty()) morphs.node_begin.push_back(0);
    std::stable_sort(displaced_.begin(), displaced_.end(),
                     [](const auto& a, const auto& b) { return a.target < b.target; });
    for (std::size_t i = 0; i < displaced_.size(); ++i) {
      if (i == 0 || displaced_[i - 1].target != displaced_[i].target)
        morphs.targets.push_back({displaced_[i].target, size32(morphs.displacements.size()), 0});
      morphs.displacements.push_back(displaced_[i].displacement);
      ++morphs.targets.back().displacement_count;
    }
    morphs.node_begin.push_back(size32(morphs.targets.size()));
    displaced_.clear();
  }

  void write_cluster(std::uint32_t slot, std::uint32_t first_vertex) {
    const auto triangles = triangles_of(slot);
    Cluster cluster;
    cluster.first_triangle = size32(tree_.triangle_ids.size());
    cluster.first_vertex = size32(tree_.cluster_vertices.size());
    named_.clear();
    for (const std::uint32_t t : triangles) {
      const auto corners = corners_in_pool(mesh_.triangles[t], first_vertex);
      tree_.corners.push_back(corners);
      tree_.triangle_ids.push_back(t);
      named_.insert(named_.end(), corners.begin(), corners.end());
    }
    std::sort(named_.begin(), named_.end());
    named_.erase(std::unique(named_.begin(), named_.end()), named_.end());
    cluster.triangle_count = static_cast<std::uint8_t>(triangles.size());
    cluster.vertex_count = static_cast<std::uint8_t>(named_.size());
    named_.resize(cluster.listed_vertex_count(), named_.back());
    tree_.cluster_vertices.insert(tree_.cluster_vertices.end(), named_.begin(), named_.end());
    tree_.clusters.push_back(cluster);
  }

  std::array<std::uint16_t, 3> corners_in_pool(const Triangle& triangle,
                                               std::uint32_t first_vertex) const {
    std::array<std::uint16_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = static_cast<std::uint16_t>(kFloatsPerVertex *
                                              (places_[welded_[triangle[k]]] - first_vertex));
    return corners;
  }

  /// Writes the position of each vertex, after appending the vertices without triangles.
  void write_vertex_places() {
    tree_.vertex_places.reserve(welded_.size());
    for (const std::uint32_t v : welded_) {
      if (places_[v] == kNowhere) write_vertex(v);
      tree_.vertex_places.push_back(places_[v]);
    }
    write_displacements();
  }

  void shrink() {
    tree_.rest_positions.shrink_to_fit();
    tree_.place_vertices.shrink_to_fit();
    tree_.offset_caps.shrink_to_fit();
    tree_.influence_begin.shrink_to_fit();
    tree_.joints.shrink_to_fit();
    tree_.weights.shrink_to_fit();
    tree_.corners.shrink_to_fit();
    tree_.triangle_ids.shrink_to_fit();
    tree_.cluster_vertices.shrink_to_fit();
    tree_.clusters.shrink_to_fit();
    tree_.nodes.shrink_to_fit();
    tree_.morphs.node_begin.shrink_to_fit();
    tree_.morphs.targets.shrink_to_fit();
    tree_.morphs.displacements.shrink_to_fit();
  }

  struct Displaced {
    std::uint32_t target;
    PlacedDisplacement displacement;
  };

  const SkinnedMesh& mesh_;
  const ClusterTree& clusters_;
  std::vector<std::uint32_t> welded_;
  std::vector<std::uint32_t> last_node_;  // by welded vertex: the last node whose pool has it
  std::vector<std::uint32_t> places_;     // by welded vertex: its last position
  std::vector<std::uint32_t> pool_;       // the welded vertices of one node
  std::vector<std::uint16_t> named_;      // the corners of one cluster
  std::vector<Displaced> displaced_;      // displacements in the pool of one node
  Tree tree_;
};

}  // namespace

Tree build_tree(const SkinnedMesh& mesh, std::span<const std::vector<Vec3>> samples) {
  const ClusterTree clusters = build_cluster_tree(SampleBoxes(mesh.triangles, samples));
  Tree tree = TreeWriter(mesh, clusters).write(collapse(clusters));
  index_triangles(tree);
  index_triangles_below(tree);
  index_welded_vertices(tree);
  return tree;
}

}  // namespace pelt::detail
