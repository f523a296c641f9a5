#pragma once

#include "asset/node_graph.hpp"

namespace pelt::asset {

/// The nodes of the scene whose meshes are wanted, in scene order (the document's numbers). Refuses
/// a name to exclude that no node has, unless it need not exist.
Result<std::vector<std::uint32_t>> choose_mesh_nodes(const GltfDocument& document,
                                                     const NodeGraph& graph,
                                                     const GltfOptions& options);

}  // namespace pelt::asset
