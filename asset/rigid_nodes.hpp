#pragma once

#include <pelt/asset.hpp>

#include <cstdint>
#include <vector>

namespace pelt::asset {

/// Returns for each node the highest node that it never moves against: the node itself if a clip
/// moves it relative to its parent. If no clip moves any node, each node is its own. Differences
/// from the default pose that nobody sees are not motion.
///
/// Cost: O(nodes + keys).
std::vector<std::uint32_t> rigid_nodes(const Asset& asset);

}  // namespace pelt::asset
