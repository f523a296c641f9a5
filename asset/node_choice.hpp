#pragma once

#include "asset/node_graph.hpp"

namespace pelt::asset {

/// Returns the nodes of the scene whose meshes to read, in scene order (the document's numbers).
/// Returns an error for a name to exclude that no node has, if it must exist.
Result<std::vector<std::uint32_t>> choose_mesh_nodes(const GltfDocument& document,
                                                     const NodeGraph& graph,
                                                     const GltfOptions& options);

}  // namespace pelt::asset
