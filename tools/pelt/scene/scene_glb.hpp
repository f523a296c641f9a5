#pragma once

/// The pictures that can be turned in any glTF viewer.

#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/posed_instances.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <vector>

namespace pelt::tools::scene {

/// The instances as they were collided: one root node each in order, one mesh, one primitive, all
/// vertices bit for bit, all triangles as numbered in the answers.
std::vector<std::byte> posed_glb(std::span<const PosedInstance> instances);

/// Whether each triangle of each instance is in contact.
std::vector<std::vector<bool>> touching_triangles(std::span<const PosedInstance> instances,
                                                  std::span<const Collider> colliders,
                                                  const FrameContacts& found);

/// The same characters, smooth, with the triangles in contact in a glowing colour.
std::vector<std::byte> contacts_glb(std::span<const PosedInstance> instances,
                                    const std::vector<std::vector<bool>>& touching);

/// Linear colours that tell neighbours apart; they repeat.
std::array<float, 3> skin_colour(std::size_t instance);

}  // namespace pelt::tools::scene
