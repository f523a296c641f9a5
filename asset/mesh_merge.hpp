#pragma once

#include "asset/accessor.hpp"
#include "asset/node_graph.hpp"

namespace pelt::asset {

/// Merges the meshes of the scene into one: fills `asset` except for its nodes and clips.
Result<void> merge_meshes(const GltfDocument& document, const NodeGraph& graph,
                          const GltfOptions& options, AccessorReader& reader, Budget& budget,
                          Asset& asset);

}  // namespace pelt::asset
