#pragma once

#include <pelt/asset.hpp>
#include <pelt/self_filter.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// Returns the posed vertices in the default pose of the nodes, without morph targets. If the
/// default pose is invalid, returns the rest positions.
std::vector<Vec3> default_positions(const asset::Asset& asset);

/// Returns which joints of a character are neighbours in its body, as pelt::near_joints of a model
/// of the asset. Needs no model.
///
/// `main_joints`: [T] the joint that each triangle follows most (see TriangleLabels).
///
/// Cost: O(T log T + V + keys of all clips).
NearJoints near_joints(const asset::Asset& asset, std::span<const std::uint16_t> main_joints,
                       std::span<const Contact> at_rest);

}  // namespace pelt::scenes
