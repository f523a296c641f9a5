#pragma once

#include <pelt/asset.hpp>
#include <pelt/self_collide.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// For the members of `SelfFilterOptions` with these names; `bodies` for `joint_bodies`.
struct NearJoints {
  std::vector<std::uint16_t> bodies;  ///< [J] the lowest joint of each joint's body
  std::vector<IndexPair> joint_pairs, joint_pairs_in_zones;  ///< of bodies
  std::vector<TriangleZone> zones;                           ///< named by bodies
};

/// Returns which joints are neighbours in the body of a character, whatever its rig looks like.
/// Joints that no clip moves against each other are one rigid body, such as a bone and the armour
/// that is attached to it. A body is near itself. Two bodies are near
/// - if one is anywhere above the other in the hierarchy, and triangles of both share a corner, as
///   at an armpit: only in the zone of the joint, where the skin creases (see joint_zones.hpp);
/// - if one is the next above the other, without bodies that move no triangles, and no triangles of
///   both share a corner;
/// - if triangles of both touch in `at_rest`, as in a ball joint, or at a foot that is no child of
///   its leg.
///
/// `main_joints`: [T] the joint that each triangle follows most (see TriangleLabels).
/// `at_rest`: contacts in reference poses, found with the filter that an empty `at_rest` gives.
/// Otherwise, joints whose skin creases at rest are near everywhere.
///
/// Cost: O(T log T + V + keys of all clips).
NearJoints near_joints(const asset::Asset& asset, std::span<const std::uint16_t> main_joints,
                       std::span<const Contact> at_rest);

}  // namespace pelt::scenes
