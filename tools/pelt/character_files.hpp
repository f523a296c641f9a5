#pragma once

/// The files of characters, to be taken elsewhere: of a scene's models only what reading them
/// needs.

#include "scenes/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace pelt::tools {

struct CharacterFiles {
  std::map<std::string, std::vector<std::byte>> bytes;  ///< by path
  std::vector<std::string> paths;                       ///< of each character; "" if generated
};

/// Each character's files lie in a folder of its own, named by its number: "0/knight.glb". Of a
/// .gltf also the buffers that it names, but no images.
Result<CharacterFiles> read_character_files(const scenes::Scene& scene);

}  // namespace pelt::tools
