#pragma once

/// The files of a scene's characters, for embedding: of each model, only the data that Pelt reads.

#include "scenes/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace pelt::tools::page {

struct CharacterFiles {
  std::map<std::string, std::vector<std::byte>> bytes;  ///< by path
  std::vector<std::string> paths;                       ///< of each character; "" if generated
  std::vector<std::size_t> original_sizes;              ///< of each character's own file
};

/// The file of each character is in a folder named by its number: "0/knight.glb". It is a .glb with
/// the buffers that its meshes and clips use, also if the model is a .gltf. Returns an error for a
/// file that has changed since the scene was read.
Result<CharacterFiles> read_character_files(const scenes::Scene& scene);

}  // namespace pelt::tools::page
