#include "asset/node_choice.hpp"
#include "asset/message.hpp"

#include <algorithm>
#include <set>

namespace pelt::asset {

namespace {

/// Returns the names of the first few mesh nodes of the scene, for a message.
std::string mesh_node_names(const GltfDocument& document, const NodeGraph& graph) {
  constexpr std::size_t kMax = 20;
  std::string names;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < graph.scene_count && count < kMax; ++i) {
    const GltfNode& node = document.nodes[graph.order[i]];
    if (node.mesh) names += (count++ == 0 ? "" : ", ") + asset::quoted(node.name);
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
               "no node to exclude is named " + asset::quoted(*unknown.begin()) +
                   "; the nodes with meshes are " + mesh_node_names(document, graph)};
}

}  // namespace

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
