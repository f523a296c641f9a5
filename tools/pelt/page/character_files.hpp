#pragma once

/// The files of characters, to be taken elsewhere: of a scene's models only what reading them
/// needs.

#include "scenes/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace pelt::tools::page {

struct CharacterFiles {
  std::map<std::string, std::vector<std::byte>> bytes;  ///< by path
  std::vector<std::string> paths;                       ///< of each character; "" if generated
};

/// Each character's files lie in a folder of its own, named by its number: "0/knight.glb", with the
/// buffers that its meshes and clips use, but no images. Refuses a file that has changed since the
/// scene was read.
Result<CharacterFiles> read_character_files(const scenes::Scene& scene);

}  // namespace pelt::tools::page
