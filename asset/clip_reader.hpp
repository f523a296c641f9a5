#pragma once

#include "asset/accessor.hpp"
#include "asset/node_graph.hpp"

namespace pelt::asset {

/// The animations of the document. What moves nothing that has been read (no node, no morph target
/// of `targets`) is passed over with a warning, but counts for a clip's duration.
Result<std::vector<Clip>> read_clips(const GltfDocument& document, const NodeGraph& graph,
                                     AccessorReader& reader,
                                     const std::vector<MorphTarget>& targets,
                                     std::vector<std::string>& warnings);

}  // namespace pelt::asset
