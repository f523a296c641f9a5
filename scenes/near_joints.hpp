#pragma once

#include <pelt/asset.hpp>
#include <pelt/self_collide.hpp>

#include <vector>

namespace pelt::scenes {

/// Returns the pairs of joints that follow one node, or a node and the nearest joint above it, for
/// `SelfFilterOptions::joint_pairs`. Includes each joint with itself. Several joints may follow one
/// node: those of different skins.
std::vector<IndexPair> near_joints(const asset::Asset& asset);

}  // namespace pelt::scenes
