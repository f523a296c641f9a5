#pragma once

/// Validated options of `pelt check`, with everything that they leave open chosen for a scene.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/options.hpp"
#include "tools/pelt/check/verdict.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/self_filters.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace pelt::tools::check {

/// Whether bodies are tested against themselves, and the contacts that do not count then.
struct SelfChoice {
  scenes::SelfContacts wanted = scenes::SelfContacts::none;
  scene::SelfRules rules;
  bool is_always_chosen = false;  ///< --self-always is given, or set by the scene

  bool asks_self() const { return wanted != scenes::SelfContacts::none; }
  bool asks_pairs() const { return wanted != scenes::SelfContacts::only; }
};

struct CheckSettings {
  CheckOptions options;  ///< as given; where a member below is chosen from one, use the member
  methods::MethodKind method = methods::kOnDemand;
  scene::Granularity granularity = scene::Granularity::instance;
  std::optional<std::uint32_t> max_contacts;  ///< per pair of colliders and frame
  /// Straight pieces of each step between frames; nullopt: steps are not tested.
  std::optional<std::uint32_t> substeps;
  SelfChoice self;
  std::vector<scenes::NamePair> ignore;
  std::optional<CheckBaseline> baseline;
  FailOn fail_on = FailOn::contact;  ///< `grown` and `newly` need a baseline
  arguments::FrameRange frames;
};

/// Returns an error for options that are wrong in themselves or conflict with each other. Call it
/// before anything is loaded, so that a list does not report the error once for each scene.
Result<void> check_options(const CheckOptions& options);

/// Returns an error for options that `check_options` refuses or that conflict with the scene,
/// before anything is computed or written. Reads the baseline. Adds notes to `scene` about what is
/// tested.
Result<CheckSettings> choose_settings(const CheckOptions& options, scenes::Scene& scene);

/// Returns a choice as options that leave no default open.
scenes::SelfOptions without_defaults(const SelfChoice& choice);

/// "options" of the header of `pelt check --jsonl`: what the answers of frames depend on besides
/// the scene's instances, and options that are stated if they are given. Ignores the baseline.
nlohmann::ordered_json question_json(const CheckSettings& settings, const scenes::Scene& scene);

}  // namespace pelt::tools::check
