#pragma once

/// The files of a scene's characters, for embedding: of each model, only the files that reading it
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

/// The files of each character are in a folder named by its number: "0/knight.glb", with the
/// buffers that its meshes and clips use, without images. Returns an error for a file that has
/// changed since the scene was read.
Result<CharacterFiles> read_character_files(const scenes::Scene& scene);

}  // namespace pelt::tools::page
