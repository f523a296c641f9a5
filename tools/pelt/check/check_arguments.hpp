#pragma once

/// The command line of `pelt check`: options and settings.

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/check/check_settings.hpp"
#include "tools/pelt/check/self_arguments.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::check {

struct CheckArguments {
  arguments::SceneArguments scene;
  std::string scenes;                  ///< file with a list of scenes, "" if absent
  methods::MethodKinds known_methods;  ///< possible values of --method
  std::string frames, by = "instance", method = "on_demand";
  bool first = false, pairs = false, contacts = false, inside = false, allow_empty = false;
  bool between = false;
  std::optional<std::uint32_t> substeps;
  std::optional<double> clearance;
  std::optional<std::uint32_t> budget;
  std::optional<std::uint32_t> max_contacts, glb_frame, threads;
  std::uint32_t list = 10;
  std::vector<std::string> ignore;
  SelfArguments self;
  std::string baseline, fail_on;
  /// The part of the baseline of a list that belongs to this scene; "": there is none, so all
  /// contacts are new. Nullopt: the baseline is the file.
  std::optional<std::string> baseline_text;
  std::string shard, shard_file;  ///< "" if absent
  std::string jsonl, glb, html, simd, words;
};

void add_check_options(arguments::Verb& verb, CheckArguments& arguments);

/// Adds the options of the verdict, of the summary and of --jsonl.
void add_verdict_options(arguments::Verb& verb, CheckArguments& arguments);

/// Adds --html and --glb.
void add_picture_options(arguments::Verb& verb, CheckArguments& arguments);

/// Returns an error for options that conflict with each other or with the scene, before anything is
/// computed or written. Reads the baseline. Adds notes to `scene` about what is tested.
Result<CheckSettings> choose_settings(const CheckArguments& arguments, scenes::Scene& scene);

}  // namespace pelt::tools::check
