#pragma once

/// Writes generated characters to files that other programs can play.

#include <pelt/asset.hpp>

#include <cstddef>
#include <vector>

namespace pelt::scenes {

/// Returns a binary glTF 2.0 file of a character with its skin, morph targets and clips. Every
/// number is exact: `asset::load_gltf` returns the same asset, with nodes depth-first. O(asset).
///
/// Precondition: the asset is like those of `make_creature` and `make_face`, with one part whose
/// node is node 0, four influences per vertex, nodes without matrices, and morph targets that
/// displace something.
std::vector<std::byte> character_glb(const asset::Asset& asset);

}  // namespace pelt::scenes
