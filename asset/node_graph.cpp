#include "asset/node_graph.hpp"

#include "text/message.hpp"

#include <algorithm>
#include <set>

namespace pelt::asset {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Returns the parent of each node, in the document's numbers.
Result<Indices> find_parents(const GltfDocument& document) {
  Indices parents(document.nodes.size(), kNoParent);
  for (std::uint32_t node = 0; node < parents.size(); ++node) {
    for (const std::uint32_t child : document.nodes[node].children) {
      if (parents[child] != kNoParent) {
        return text::malformed(node_label(document, child) + " is a child of both " +
                               node_label(document, parents[child]) + " and " +
                               node_label(document, node));
      }
      parents[child] = node;
    }
  }
  return parents;
}

/// Returns the roots of the scene to read: the default scene of the file, or else its first scene.
/// A file without scenes has all its nodes in one scene.
Indices scene_roots(const GltfDocument& document, const Indices& parents) {
  if (!document.scenes.empty()) return document.scenes[document.scene.value_or(0)];
  Indices roots;
  for (std::uint32_t node = 0; node < parents.size(); ++node) {
    if (parents[node] == kNoParent) roots.push_back(node);
  }
  return roots;
}

/// Appends the tree below `root`, depth-first. Chains of nodes may be long, so it does not recurse.
void append_tree(const GltfDocument& document, std::uint32_t root, NodeGraph& graph) {
  Indices stack = {root};
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    graph.position[node] = static_cast<std::uint32_t>(graph.order.size());
    graph.order.push_back(node);
    const Indices& children = document.nodes[node].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
}

Result<void> append_scene(const GltfDocument& document, const Indices& parents, NodeGraph& graph) {
  for (const std::uint32_t root : scene_roots(document, parents)) {
    if (parents[root] != kNoParent) {
      return text::malformed(node_label(document, root) +
                             " is a root of the scene and a child of " +
                             node_label(document, parents[root]));
    }
    if (graph.position[root] != kNoParent) {
      return text::malformed(node_label(document, root) + " is a root of the scene twice");
    }
    append_tree(document, root, graph);
  }
  graph.scene_count = static_cast<std::uint32_t>(graph.order.size());
  return {};
}

Result<void> append_others(const GltfDocument& document, const Indices& parents, NodeGraph& graph) {
  for (std::uint32_t node = 0; node < parents.size(); ++node) {
    if (parents[node] == kNoParent && graph.position[node] == kNoParent) {
      append_tree(document, node, graph);
    }
  }
  for (std::uint32_t node = 0; node < parents.size(); ++node) {
    if (graph.position[node] == kNoParent) {
      return text::malformed(node_label(document, node) + " is in a cycle of children");
    }
  }
  return {};
}

/// Returns the names of the first few mesh nodes of the scene, for a message.
std::string mesh_node_names(const GltfDocument& document, const NodeGraph& graph) {
  constexpr std::size_t kMax = 20;
  std::string names;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < graph.scene_count && count < kMax; ++i) {
    const GltfNode& node = document.nodes[graph.order[i]];
    if (node.mesh) names += (count++ == 0 ? "" : ", ") + text::quoted(node.name);
  }
  return count < kMax ? names : names + ", ...";
}

/// Returns for each node of the scene whether the node or an ancestor has one of the names.
Result<std::vector<bool>> find_excluded(const GltfDocument& document, const NodeGraph& graph,
                                        const GltfOptions& options) {
  std::set<std::string_view> unknown(options.exclude_nodes.begin(), options.exclude_nodes.end());
  const std::set<std::string_view> wanted = unknown;
  std::vector<bool> excluded(graph.scene_count);
  for (std::uint32_t i = 0; i < graph.scene_count; ++i) {
    const std::string& name = document.nodes[graph.order[i]].name;
    const bool above = graph.parent[i] != kNoParent && excluded[graph.parent[i]];
    excluded[i] = above || wanted.count(name) > 0;
    unknown.erase(name);
  }
  if (unknown.empty() || !options.excluded_must_exist) return excluded;
  return Error{ErrorCode::invalid_argument,
               "no node to exclude is named " + text::quoted(*unknown.begin()) +
                   "; the nodes with meshes are " + mesh_node_names(document, graph)};
}

}  // namespace

Result<NodeGraph> order_nodes(const GltfDocument& document) {
  const Result<Indices> parents = find_parents(document);
  if (!parents) return parents.error();
  NodeGraph graph;
  graph.position.assign(document.nodes.size(), kNoParent);
  const Result<void> scene = append_scene(document, *parents, graph);
  if (!scene) return scene.error();
  const Result<void> others = append_others(document, *parents, graph);
  if (!others) return others.error();
  for (const std::uint32_t node : graph.order) {
    const std::uint32_t parent = (*parents)[node];
    graph.parent.push_back(parent == kNoParent ? kNoParent : graph.position[parent]);
  }
  return graph;
}

std::string node_label(const GltfDocument& document, std::uint32_t node) {
  return text::label("node", node, document.nodes[node].name);
}

Result<std::vector<std::uint32_t>> choose_mesh_nodes(const GltfDocument& document,
                                                     const NodeGraph& graph,
                                                     const GltfOptions& options) {
  const Result<std::vector<bool>> excluded = find_excluded(document, graph, options);
  if (!excluded) return excluded.error();
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < graph.scene_count; ++i) {
    const GltfNode& node = document.nodes[graph.order[i]];
    const bool wanted = node.skin || options.unskinned_parts;
    if (node.mesh && wanted && !(*excluded)[i]) chosen.push_back(graph.order[i]);
  }
  return chosen;
}

}  // namespace pelt::asset
