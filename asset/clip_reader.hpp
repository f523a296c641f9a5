#pragma once

#include "asset/accessor.hpp"
#include "asset/node_graph.hpp"

namespace pelt::asset {

/// Reads the animations of the document. Channels that animate nothing that was read (no node, no
/// morph target of `targets`) are ignored with a warning, but count for the duration of the clip.
Result<std::vector<Clip>> read_clips(const GltfDocument& document, const NodeGraph& graph,
                                     AccessorReader& reader,
                                     const std::vector<MorphTarget>& targets,
                                     std::vector<std::string>& warnings);

}  // namespace pelt::asset
