#pragma once

/// Names of parts and joints, by which a person finds them in the file.

#include <pelt/asset.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pelt::scenes {

/// Returns the names of all parts: of the part's node, or of its mesh if the node has no name;
/// "node:material" or "node:number" if several parts share that name. Cost: O(parts).
std::vector<std::string> part_names(const asset::Asset& asset);

/// Returns the name of the joint's node, or "joint 7" if it has none.
std::string joint_name(const asset::Asset& asset, std::uint32_t joint);

/// Returns the names of all joints.
std::vector<std::string> joint_names(const asset::Asset& asset);

}  // namespace pelt::scenes
