#pragma once

/// What parts and joints are called, so that a person can find them in the file.

#include <pelt/asset.hpp>

#include <cstdint>
#include <string>

namespace pelt::scenes {

/// The node of a part, or its mesh where the node has no name; "node:material" or "node:number"
/// where several parts share that.
std::string part_name(const asset::Asset& asset, std::uint32_t part);

/// The name of a joint's node; "joint 7" where it has none.
std::string joint_name(const asset::Asset& asset, std::uint32_t joint);

}  // namespace pelt::scenes
