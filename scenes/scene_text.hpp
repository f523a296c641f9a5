#pragma once

/// A scene as the text of a scene file again, for whoever takes it elsewhere.

#include "scenes/scene.hpp"

#include <span>
#include <string>

namespace pelt::scenes {

/// What `parse_scene` reads as this scene, all numbers to the last bit. `paths` are those of the
/// characters' files in it; that of a generated one does not matter. Characters of the same name
/// get numbers. Precondition: as many paths as characters. O(instances).
std::string scene_text(const Scene& scene, std::span<const std::string> paths);

}  // namespace pelt::scenes
