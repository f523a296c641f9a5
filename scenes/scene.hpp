#pragma once

/// An animated scene: characters, where they stand and what they play, frame by frame. Shared by
/// the command, the benchmark and the tests, so that what is timed is what is tested and shown.

#include <pelt/asset.hpp>
#include <pelt/model.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pelt::scenes {

/// A character as the scene names it.
struct Character {
  std::string name;          ///< key in the scene's "models", or the file's stem
  std::string path;          ///< as written in the scene; empty for a generated one
  std::uint64_t hash = 0;    ///< FNV-1a 64 of the file's bytes, or of the generator's parameters
  asset::Asset asset;
};

struct Instance {
  std::uint32_t character = 0;  ///< index into Scene::characters
  /// Empty optional: default node pose; "": the unnamed clip.
  std::optional<std::string> clip;
  double start = 0, speed = 1;  ///< clip time = (start + speed * t) mod duration
  std::array<double, 3> translation = {0, 0, 0};
  std::array<double, 4> rotation = {0, 0, 0, 1};  ///< x y z w
  double scale = 1;
  std::array<double, 3> velocity = {0, 0, 0};     ///< units per second
};

struct Scene {
  std::string name;  ///< file name of the scene, for reports
  std::vector<Character> characters;
  std::vector<Instance> instances;
  std::uint32_t frame_count = 1;
  double fps = 30;
};

/// Reads the JSON scene format (docs/scene.schema.json); paths in it are relative to its folder.
/// Unknown keys, wrong types, missing clips and bad characters are refused with the path inside
/// the file.
Result<Scene> load_scene(const std::filesystem::path& path);

/// Seconds at which frame `frame` stands: frame / fps.
double frame_time(const Scene& scene, std::uint32_t frame);

/// The joint palette of one instance at one frame:
/// world = T(translation + velocity t) R(rotation) S(scale), then the clip's pose.
/// Precondition: `palette` has as many matrices as the instance's asset has joints.
void instance_palette(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette);

}  // namespace pelt::scenes
