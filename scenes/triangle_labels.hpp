#pragma once

/// Labels of triangles, and the joints near them.

#include <pelt/asset.hpp>
#include <pelt/result.hpp>
#include <pelt/self_filter.hpp>

#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// Returns the validated mesh of an asset without morph targets, with weights that sum to 1.
Result<detail::SkinnedMesh> mesh_without_morphs(const asset::Asset& asset);

/// Joint and part of each triangle of a character, as numbered in the asset.
struct TriangleLabels {
  std::vector<std::uint16_t> joint;  ///< [T] the joint of largest weight, as in ContactPatch
  std::vector<std::uint32_t> part;   ///< [T] the part with the triangle
};

/// Returns the errors of `build_model`, except for weights that do not sum to 1. O(influences of
/// all vertices and triangles).
Result<TriangleLabels> label_triangles(const asset::Asset& asset);

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
