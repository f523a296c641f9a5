#pragma once

/// Generated characters as files that other programs can play.

#include <pelt/asset.hpp>

#include <cstddef>
#include <vector>

namespace pelt::scenes {

/// A binary glTF 2.0 file of a character, its skin, morph targets and clips, every number bit for
/// bit: `asset::load_gltf` gives the same asset, its nodes depth-first. O(asset).
///
/// Precondition: as `make_creature` and `make_face` make them: one part, whose node is node 0, four
/// influences a vertex, nodes without matrices, and each morph target displaces something.
std::vector<std::byte> character_glb(const asset::Asset& asset);

}  // namespace pelt::scenes
