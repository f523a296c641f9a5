#pragma once

/// An animated scene: characters with placements and clips. The command, the benchmark and the
/// tests share this code, so that the same scenes are measured, tested and shown.

#include <pelt/asset.hpp>
#include <pelt/model.hpp>
#include <pelt/result.hpp>

#include "scenes/creature.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pelt::scenes {

/// Whether a check tests bodies against each other, against themselves, or both.
enum class SelfContacts : std::uint8_t {
  none,    ///< pairs of bodies only
  beside,  ///< pairs of bodies, and each body against itself
  only,    ///< each body against itself only
};

/// Choices that are not set have the defaults of the command (see docs/self-collision.md).
struct SelfOptions {
  std::optional<SelfContacts> wanted;
  std::optional<std::uint32_t> rings;
  std::optional<bool> drops_at_rest;
  std::optional<double> always;  ///< share of the poses, at most 1; 0: drops nothing
  std::optional<bool> drops_near_joints;
};

inline constexpr std::uint32_t kMaxSelfRings = 64;

/// Returns the choices of `first`, and those of `second` where `first` has none.
inline SelfOptions chosen_first(const SelfOptions& first, const SelfOptions& second) {
  const auto either = [](const auto& a, const auto& b) { return a ? a : b; };
  return {either(first.wanted, second.wanted), either(first.rings, second.rings),
          either(first.drops_at_rest, second.drops_at_rest), either(first.always, second.always),
          either(first.drops_near_joints, second.drops_near_joints)};
}

/// A character of a scene.
struct Character {
  std::string name;        ///< key in the scene's "models", or the file's stem
  std::string source;      ///< the path as written, or "creature:13590:56:1" or "face:4000:1"
  std::uint64_t hash = 0;  ///< FNV-1a 64 of the file's bytes, or of `source`
  asset::Asset asset;
  /// Path of its file, relative to the working directory, or the options that it was generated
  /// with.
  std::variant<std::filesystem::path, CreatureOptions, FaceOptions> origin = {};
  std::vector<std::uint32_t> buffer_views = {};  ///< of its file, used by meshes and clips
  std::optional<Skinning> skinning = {};         ///< as the scene says
};

/// The name of a kind of skinning in scene files and on the command line.
const char* name_of(Skinning skinning);

/// A fixed weight of a morph target, which overrides the clip.
struct MorphWeight {
  /// Index into Asset::morph_targets, or a name, which may match several targets.
  std::variant<std::uint32_t, std::string> target;
  float weight = 0;
};

struct Instance {
  std::uint32_t character = 0;  ///< index into Scene::characters
  /// nullopt: default node pose; "": the unnamed clip; "*": all clips, see Scene::takes
  std::optional<std::string> clip;
  double start = 0, speed = 1;  ///< clip time = (start + speed t) mod duration
  std::array<double, 3> translation = {0, 0, 0};
  std::array<double, 4> rotation = {0, 0, 0, 1};  ///< x y z w, any length but 0
  double scale = 1;
  std::array<double, 3> velocity = {0, 0, 0};  ///< units per second
  std::vector<MorphWeight> morph_weights;      ///< other targets follow the clip
};

/// Names of parts or joints whose contacts with each other do not count. `*` matches any
/// characters; "knight/Cape" is a name of one character only.
struct NamePair {
  std::string a, b;
};

/// Consecutive frames in which the instances that play all clips play one clip of their characters.
/// Time starts again with each take.
struct Take {
  std::string clip;
  std::uint32_t first_frame = 0, frame_count = 0;
};

struct Scene {
  std::string name;  ///< file name of the scene, for reports
  std::vector<Character> characters;
  std::vector<Instance> instances;
  std::uint32_t frame_count = 1;
  double fps = 30;
  std::vector<NamePair> ignore;
  SelfOptions self = {};           ///< contacts of characters with themselves
  std::vector<std::string> notes;  ///< hints about probable mistakes, with remedies, for reports
  /// One for each clip, for all frames, if an instance plays all clips; otherwise empty. Set by
  /// `plan_takes` (scenes/takes.hpp).
  std::vector<Take> takes = {};
};

inline constexpr std::uint32_t kMaxFrames = 1'000'000;
inline constexpr double kMinFps = 1e-6, kMaxFps = 1e6;
inline constexpr double kMinScale = 1e-6, kMaxScale = 1e6;

/// Reads the JSON scene format (docs/scenes.md). Paths in it are relative to its folder. Names to
/// exclude match nodes of all models or of one (scenes/excluded_nodes.hpp).
///
/// Returns an error with the place in the file for unknown keys, wrong types, missing clips and
/// invalid characters.
///
/// Cost: that of `load_character` or `generate_character` once per model, and O(instances times
/// clips of their characters). The assets stay in memory.
Result<Scene> load_scene(const std::filesystem::path& path, const asset::GltfOptions& options = {});

/// Reads a scene from the text of a file, with paths relative to `folder`.
Result<Scene> parse_scene(std::string_view text, const std::filesystem::path& folder,
                          const asset::GltfOptions& options = {});

/// Reads one character from a glTF file. Error messages start with the path. Cost: that of
/// `asset::load_gltf`, and O(bytes of the file) for the hash.
Result<Character> load_character(const std::filesystem::path& path,
                                 const asset::GltfOptions& options = {});

/// Generates a character. Same cost as `make_creature`.
Result<Character> generate_character(const CreatureOptions& options);
Result<Character> generate_character(const FaceOptions& options);

/// Returns an error if the character of an instance does not have the instance's clip. The message
/// lists the known clips. For "*", returns the errors of `check_all_clips`. O(clips log clips).
Result<void> check_clip(const Scene& scene, std::uint32_t instance);

/// Returns an error if the character of an instance does not have the morph targets of its weights.
/// The message lists the known targets. O(weights times targets).
Result<void> check_morph_weights(const Scene& scene, std::uint32_t instance);

/// Returns the time of a frame in seconds: its number, counted from the first frame of its take if
/// the scene has takes, divided by fps. O(log takes).
double frame_time(const Scene& scene, std::uint32_t frame);

/// A time of a scene: this many frames after a frame, in the same take.
struct Moment {
  std::uint32_t frame = 0;
  double later = 0;
};

/// Returns the time of a moment in seconds, as `frame_time` does. O(log takes).
double moment_time(const Scene& scene, const Moment& moment);

/// Writes the joint palette of one instance at one frame: the clip's pose, transformed by
/// T(translation + velocity t) R(rotation) S(scale). Cost and allocation: those of
/// `asset::sample_palette`, and O(clips).
///
/// Precondition: `palette` has one matrix per joint of the instance's asset.
void instance_palette(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette);

/// Writes the joint palette of one instance at a moment. If the moment is a frame, the palette is
/// that of the frame.
void instance_palette(const Scene& scene, std::uint32_t instance, const Moment& moment,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette);

/// Writes the morph weights of one instance at one frame: its fixed weights, and otherwise those of
/// its clip. Cost: that of `asset::sample_morph_weights` and `check_morph_weights`, and O(clips).
///
/// Precondition: `weights` has one element per morph target of the instance's asset.
void instance_morph_weights(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                            std::span<float> weights);
void instance_morph_weights(const Scene& scene, std::uint32_t instance, const Moment& moment,
                            std::span<float> weights);

/// Writes the joint palette of an instance without a scene at a time. Precondition: `asset` has the
/// instance's clip, and the instance plays one clip only.
void instance_palette(const asset::Asset& asset, const Instance& instance, double seconds,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette);
void instance_morph_weights(const asset::Asset& asset, const Instance& instance, double seconds,
                            std::span<float> weights);

}  // namespace pelt::scenes
