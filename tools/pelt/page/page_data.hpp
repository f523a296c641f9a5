#pragma once

/// Data of a scene for the viewer's page (viewer/README.md describes the format).

#include <pelt/collide.hpp>
#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <cstdint>
#include <map>
#include <optional>
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

/// A step in which triangles touch that touch in neither of its frames.
struct PageStep {
  std::uint32_t from = 0, to = 0;  ///< frames
  std::uint64_t contacts = 0;      ///< that touch in neither frame

  /// The contact of these that touches first: when, in the clip; which share of the step has passed
  /// then; instances; triangle numbers of the assets; and whether a body touches itself.
  double first_seconds = 0;
  double first_share = 0;
  std::uint32_t a = 0, b = 0;
  Contact triangles;
  bool is_of_self = false;
};

/// Results of `pelt check`, which the page compares with its own.
struct PageAnswer {
  std::vector<std::uint64_t> counts;           ///< contacts of each frame
  std::string lines;                           ///< the first and the last line of --jsonl
  std::optional<std::vector<PageStep>> steps;  ///< with --between
};

struct PageData {
  std::string command;               ///< the command line of the check
  std::optional<PageAnswer> answer;  ///< nullopt: the page runs the queries itself
};

/// The data as JSON: the scene with all its files, the options for reading it, and the results.
/// Reads the files again, and returns an error for files that have changed since the scene was
/// read.
Result<std::string> page_data(const scenes::Scene& scene, const arguments::ModelArguments& models,
                              const PageData& data);

}  // namespace pelt::tools::page
