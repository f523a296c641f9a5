#pragma once

/// The options of `pelt check`, as rows of one table. From the table come the command lines of
/// `pelt check` and `pelt merge`, the arguments in files of shards, and the options in the header
/// of an answer that need no rule of their own. A second table holds the conflicts between options.

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/methods/method.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::tools::check {

/// The options as given. Empty or nullopt: the option is absent.
struct CheckOptions {
  arguments::SceneArguments scene;
  std::string scenes;  ///< file with a list of scenes

  std::string frames, by = "instance", method = "on_demand", simd;
  std::optional<std::uint32_t> threads;
  bool first = false;
  std::optional<std::uint32_t> max_contacts;
  std::string self;
  std::optional<std::uint32_t> self_rings;
  std::string self_at_rest, self_always, self_near_joints;
  std::vector<std::string> ignore;

  std::string baseline, fail_on;
  bool allow_empty = false;
  std::uint32_t list = 10;
  std::string jsonl;

  bool pairs = false, contacts = false, inside = false;
  std::optional<double> clearance;
  std::optional<std::uint32_t> budget;
  bool between = false;
  std::optional<std::uint32_t> substeps;

  std::string html, glb;
  std::optional<std::uint32_t> glb_frame;
  std::string shard, shard_file;

  methods::MethodKinds known_methods;  ///< possible values of --method
  std::string words;                   ///< the command line
  /// The part of the baseline of a list that belongs to this scene; "": there is none, so all
  /// contacts are new. Nullopt: the baseline is the file.
  std::optional<std::string> baseline_text;
};

/// Adds the options of `pelt check`, with those of its scene.
void add_check_options(arguments::Verb& verb, CheckOptions& options);

/// Adds the options of the verdict and of the outputs, which `pelt merge` has, too.
void add_outcome_options(arguments::Verb& verb, CheckOptions& options);

/// Copies what does not affect the answers of frames: the options of the verdict, of the outputs
/// and of the machine, and the words of the command line.
void copy_outcome(const CheckOptions& from, CheckOptions& to);

/// Names of conditions that conflict with options but are not options.
inline constexpr const char* kShardsOfList = "shards of a list of scenes";
inline constexpr const char* kIgnoredPairs =
    "ignored pairs, because the first contacts may be ignored ones";

/// Returns the first conflict between options that are given. `also`: what is true, too, though no
/// option gives it: one of the two above, or "--self" if bodies are tested against themselves.
Result<void> check_conflicts(const CheckOptions& options, std::string_view also = {});

/// The options as "arguments" of a file of a shard: those that the answers of frames depend on, and
/// those of the verdict, which are given only for a list of scenes.
nlohmann::ordered_json arguments_json(const CheckOptions& options);

/// Whether `json` has the keys that `arguments_json` writes, and no others. Otherwise a build with
/// other options wrote it.
bool has_known_options(const nlohmann::json& json);

/// Sets the options that `arguments_json` wrote. Returns false if one is missing or has another
/// type.
bool read_options(const nlohmann::json& json, CheckOptions& options);

/// Adds the options that are given, and whose rows say so, to "options" of the header of an answer.
void add_stated(const CheckOptions& options, nlohmann::ordered_json& header);

/// The keys of all options that `add_stated` may add.
std::vector<std::string> stated_keys();

}  // namespace pelt::tools::check
