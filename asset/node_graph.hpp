#pragma once

/// The nodes of a file, and which of them are read.

#include "asset/document.hpp"

namespace pelt::asset {

/// The nodes of a document in Pelt's order, parents first: depth-first through the scene, children
/// in order, then the nodes that are in no scene.
struct NodeGraph {
  std::vector<std::uint32_t> order;     ///< [N] the document's number of each
  std::vector<std::uint32_t> position;  ///< [N] the inverse: Pelt's number of the document's node
  std::vector<std::uint32_t> parent;    ///< [N] in Pelt's numbers, kNoParent for roots
  std::uint32_t scene_count = 0;        ///< this number of nodes, the first ones, are in the scene
};

/// Orders the nodes. Returns an error that names a node with two parents or in a cycle.
Result<NodeGraph> order_nodes(const GltfDocument& document);

/// `node 12 "Hips"`.
std::string node_label(const GltfDocument& document, std::uint32_t node);

/// Returns the nodes of the scene whose meshes to read, in scene order (the document's numbers).
/// Returns an error for a name to exclude that no node has, if it must exist.
Result<std::vector<std::uint32_t>> choose_mesh_nodes(const GltfDocument& document,
                                                     const NodeGraph& graph,
                                                     const GltfOptions& options);

}  // namespace pelt::asset
