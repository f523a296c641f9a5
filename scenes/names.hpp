#pragma once

/// Names of parts and joints, by which a person finds them in the file.

#include <pelt/asset.hpp>

#include <cstdint>
#include <string>

namespace pelt::scenes {

/// Returns the name of the part's node, or of its mesh if the node has no name; "node:material" or
/// "node:number" if several parts share that name.
std::string part_name(const asset::Asset& asset, std::uint32_t part);

/// Returns the name of the joint's node, or "joint 7" if it has none.
std::string joint_name(const asset::Asset& asset, std::uint32_t joint);

}  // namespace pelt::scenes
