#include "asset/node_graph.hpp"
#include "asset/message.hpp"

namespace pelt::asset {

namespace {

using Indices = std::vector<std::uint32_t>;

/// Returns the parent of each node, in the document's numbers.
Result<Indices> find_parents(const GltfDocument& document) {
  Indices parents(document.nodes.size(), kNoParent);
  for (std::uint32_t node = 0; node < parents.size(); ++node) {
    for (const std::uint32_t child : document.nodes[node].children) {
      if (parents[child] != kNoParent) {
        return malformed(node_label(document, child) + " is a child of both " +
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
      return malformed(node_label(document, root) + " is a root of the scene and a child of " +
                       node_label(document, parents[root]));
    }
    if (graph.position[root] != kNoParent) {
      return malformed(node_label(document, root) + " is a root of the scene twice");
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
      return malformed(node_label(document, node) + " is in a cycle of children");
    }
  }
  return {};
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
  return label("node", node, document.nodes[node].name);
}

}  // namespace pelt::asset
