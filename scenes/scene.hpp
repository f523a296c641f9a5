#pragma once

/// An animated scene: characters, where they stand and what they play, frame by frame. Shared by
/// the command, the benchmark and the tests, so that what is timed is what is tested and shown.

#include <pelt/asset.hpp>
#include <pelt/result.hpp>

#include "scenes/creature.hpp"
#include "scenes/face.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pelt::scenes {

/// A character as the scene names it.
struct Character {
  std::string name;    ///< key in the scene's "models", or the file's stem
  std::string source;  ///< the path as it was written, or "creature:13590:56:1" or "face:4000:1"
  std::uint64_t hash = 0;  ///< FNV-1a 64 of the file's bytes, or of `source`
  asset::Asset asset;
  /// The path of its file from the working directory, or what it was generated from.
  std::variant<std::filesystem::path, CreatureOptions, FaceOptions> origin = {};
};

/// A weight that stays as it is, whatever the clip plays.
struct MorphWeight {
  /// Index into Asset::morph_targets, or a name, which several may have.
  std::variant<std::uint32_t, std::string> target;
  float weight = 0;
};

struct Instance {
  std::uint32_t character = 0;      ///< index into Scene::characters
  std::optional<std::string> clip;  ///< nothing: default node pose; "": the unnamed clip
  double start = 0, speed = 1;      ///< clip time = (start + speed t) mod duration
  std::array<double, 3> translation = {0, 0, 0};
  std::array<double, 4> rotation = {0, 0, 0, 1};  ///< x y z w, any length but 0
  double scale = 1;
  std::array<double, 3> velocity = {0, 0, 0};  ///< units per second
  std::vector<MorphWeight> morph_weights;      ///< of other targets the clip has the say
};

/// Names of parts or joints whose contacts with each other do not count. A `*` stands for any
/// characters; "knight/Cape" is a name of one character alone.
struct NamePair {
  std::string a, b;
};

struct Scene {
  std::string name;  ///< file name of the scene, for reports
  std::vector<Character> characters;
  std::vector<Instance> instances;
  std::uint32_t frame_count = 1;
  double fps = 30;
  std::vector<NamePair> ignore;
  std::vector<std::string> notes;  ///< what may not be meant so, and what to do then, for reports
};

inline constexpr std::uint32_t kMaxFrames = 1'000'000;
inline constexpr double kMinFps = 1e-6, kMaxFps = 1e6;
inline constexpr double kMinScale = 1e-6, kMaxScale = 1e6;

/// Reads the JSON scene format (docs/scenes.md); paths in it are relative to its folder. Unknown
/// keys, wrong types, missing clips and bad characters are refused with the path inside the file.
/// A name to exclude is of any of the models, or of one (scenes/excluded_nodes.hpp).
/// Costs what `load_character` or `generate_character` does for each of its models, however many
/// instances have it, and O(instances times clips of their characters) beside; the assets stay in
/// memory.
Result<Scene> load_scene(const std::filesystem::path& path, const asset::GltfOptions& options = {});

/// The same from the text of such a file, whose paths are relative to `folder`.
Result<Scene> parse_scene(std::string_view text, const std::filesystem::path& folder,
                          const asset::GltfOptions& options = {});

/// Reads one character from a glTF file; the message of an error begins with the path. Costs what
/// `asset::load_gltf` does, and O(bytes of the file) for the hash.
Result<Character> load_character(const std::filesystem::path& path,
                                 const asset::GltfOptions& options = {});

/// A generated one. Costs what `make_creature` does.
Result<Character> generate_character(const CreatureOptions& options);
Result<Character> generate_character(const FaceOptions& options);

/// Refuses an instance whose clip its character does not have, naming those that it has. O(clips).
Result<void> check_clip(const Scene& scene, std::uint32_t instance);

/// Refuses an instance with weights of morph targets that its character does not have, naming what
/// it has. O(weights times targets).
Result<void> check_morph_weights(const Scene& scene, std::uint32_t instance);

/// Seconds at which frame `frame` stands: frame / fps. O(1).
double frame_time(const Scene& scene, std::uint32_t frame);

/// The joint palette of one instance at one frame:
/// world = T(translation + velocity t) R(rotation) S(scale), then the clip's pose.
/// Costs what `asset::sample_palette` does and O(clips), and allocates as that does.
/// Precondition: `palette` has as many matrices as the instance's asset has joints.
void instance_palette(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette);

/// The weights of the morph targets of one instance at one frame: its own, and where it has none
/// those that its clip plays. Costs what `asset::sample_morph_weights` and `check_morph_weights` do
/// and O(clips). Precondition: `weights` has as many elements as the instance's asset has morph
/// targets.
void instance_morph_weights(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                            std::span<float> weights);

/// The same of an instance that stands in no scene, at a time. Precondition: `asset` has its clip.
void instance_palette(const asset::Asset& asset, const Instance& instance, double seconds,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette);
void instance_morph_weights(const asset::Asset& asset, const Instance& instance, double seconds,
                            std::span<float> weights);

}  // namespace pelt::scenes
