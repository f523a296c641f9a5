#pragma once

/// Writes a scene as the text of a scene file.

#include "scenes/scene.hpp"

#include <span>
#include <string>

namespace pelt::scenes {

/// Returns a text from which `parse_scene` reads this scene, with every number exact. `paths` are
/// the paths to write for the characters' files; those of generated characters are ignored.
/// Characters with the same name get numbers. Precondition: one path per character. O(instances).
std::string scene_text(const Scene& scene, std::span<const std::string> paths);

}  // namespace pelt::scenes
