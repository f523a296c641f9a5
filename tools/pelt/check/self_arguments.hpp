#pragma once

/// Options of `pelt check` for contacts of characters with themselves.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/self_filters.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace pelt::tools::check {

struct SelfArguments {
  std::string self;  ///< "" if the option is absent
  std::optional<std::uint32_t> rings;
  std::string at_rest, always, near_joints;  ///< "" if absent
};

void add_self_options(arguments::Verb& verb, SelfArguments& arguments);

/// Validates the options.
Result<scenes::SelfOptions> parse_self(const SelfArguments& arguments);

/// Whether bodies are tested against themselves, and the contacts that do not count then.
struct SelfChoice {
  scenes::SelfContacts wanted = scenes::SelfContacts::none;
  scene::SelfRules rules;
  bool is_always_chosen = false;  ///< --self-always is given, or set by the scene

  bool asks_self() const { return wanted != scenes::SelfContacts::none; }
  bool asks_pairs() const { return wanted != scenes::SelfContacts::only; }
};

/// Fills in the defaults. `otherwise` is the default of --self. Contacts at rest count by default
/// if the scene has no other poses, because otherwise nothing could be found.
SelfChoice with_defaults(const scenes::SelfOptions& options, const scenes::Scene& scene,
                         scenes::SelfContacts otherwise);

/// Returns the choice as options that leave no default open.
scenes::SelfOptions without_defaults(const SelfChoice& choice);

/// Whether the scene has only one collider, so that the contacts with itself are its only ones.
bool is_one_body(const scenes::Scene& scene, scene::Granularity granularity);

}  // namespace pelt::tools::check
