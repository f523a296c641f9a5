#pragma once

/// The output of `--glb` and `pelt pose`, for any glTF viewer.

#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/posed_instances.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <vector>

namespace pelt::tools::scene {

/// The instances as the queries pose them: one root node each in order, one mesh, one primitive,
/// with bit-exact vertices and the triangle numbers of the answers.
std::vector<std::byte> posed_glb(std::span<const PosedInstance> instances);

/// Whether each triangle of each instance is in contact.
std::vector<std::vector<bool>> touching_triangles(std::span<const PosedInstance> instances,
                                                  std::span<const Collider> colliders,
                                                  const FrameContacts& found);

/// The same characters with smooth normals; the triangles in contact have a glowing colour.
std::vector<std::byte> contacts_glb(std::span<const PosedInstance> instances,
                                    const std::vector<std::vector<bool>>& touching);

/// Linear colours that distinguish neighbours; they repeat.
std::array<float, 3> skin_colour(std::size_t instance);

}  // namespace pelt::tools::scene
