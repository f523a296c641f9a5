#include "tools/pelt/check/self_arguments.hpp"

#include "asset/message.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <charconv>

namespace pelt::tools::check {
namespace {

using scenes::SelfContacts;

Result<std::optional<SelfContacts>> parse_wanted(const std::string& text) {
  using Wanted = std::optional<SelfContacts>;
  if (text.empty()) return Wanted();
  if (text == "yes") return Wanted(SelfContacts::beside);
  if (text == "no") return Wanted(SelfContacts::none);
  if (text == "only") return Wanted(SelfContacts::only);
  return output::bad_argument("--self", "unknown value " + asset::quoted(text),
                              "give --self, --self=only or --self=no");
}

/// Parses "keep" or "drop".
Result<std::optional<bool>> parse_drops(const char* option, const std::string& text) {
  if (text.empty()) return std::optional<bool>();
  if (text == "keep" || text == "drop") return std::optional<bool>(text == "drop");
  return output::bad_argument(option, "unknown value " + asset::quoted(text), "give keep or drop");
}

Result<std::optional<double>> parse_always(const std::string& text) {
  if (text.empty()) return std::optional<double>();
  if (text == "keep") return std::optional<double>(0);
  double share = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, share);
  if (error == std::errc() && read == end && share > 0 && share <= 1)
    return std::optional<double>(share);
  return output::bad_argument("--self-always", "unknown value " + asset::quoted(text),
                              "give keep, or a share of the frames such as 0.95, at most 1");
}

/// Whether any pose of the scene can differ from the default poses of its models.
bool poses_anything(const scenes::Scene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(),
                     [](const scenes::Instance& instance) {
                       return instance.clip.has_value() || !instance.morph_weights.empty();
                     });
}

template <typename T>
const Error* error_of(const Result<T>& result) {
  return result ? nullptr : &result.error();
}

}  // namespace

void add_self_options(arguments::Verb& verb, SelfArguments& arguments) {
  constexpr const char* kGroup = "Contacts of a character with itself";
  verb.choice("--self", arguments.self, "yes|only|no",
              "Also test each character against itself; only: test nothing else (default: yes for "
              "a single character, no for several)");
  verb.option("--self-rings", arguments.rings,
              "Drop contacts of triangles that are at most K steps apart, each step to a triangle "
              "that shares a corner; 0 drops nothing (default: 5)",
              {.type = "K", .most = scenes::kMaxSelfRings, .group = kGroup});
  verb.option("--self-at-rest", arguments.at_rest,
              "Contacts that the character also has in its rest pose or default pose (default: "
              "drop; keep if no instance plays a clip or sets morph weights)",
              {.type = "keep|drop", .group = kGroup});
  verb.option("--self-always", arguments.always,
              "Drop contacts of triangles that intersect in at least this share of the checked "
              "frames, such as 0.95 (default: keep)",
              {.type = "SHARE|keep", .group = kGroup});
  verb.option("--self-near-joints", arguments.near_joints,
              "Contacts of triangles whose main joints are the same or neighbours; of neighbours "
              "that share skin, only contacts near their joint (default: drop)",
              {.type = "keep|drop", .group = kGroup});
}

Result<scenes::SelfOptions> parse_self(const SelfArguments& arguments) {
  const auto wanted = parse_wanted(arguments.self);
  const auto at_rest = parse_drops("--self-at-rest", arguments.at_rest);
  const auto always = parse_always(arguments.always);
  const auto near_joints = parse_drops("--self-near-joints", arguments.near_joints);
  for (const Error* error :
       {error_of(wanted), error_of(at_rest), error_of(always), error_of(near_joints)})
    if (error) return *error;
  return scenes::SelfOptions{*wanted, arguments.rings, *at_rest, *always, *near_joints};
}

SelfChoice with_defaults(const scenes::SelfOptions& options, const scenes::Scene& scene,
                         SelfContacts otherwise) {
  SelfChoice choice;
  choice.wanted = options.wanted.value_or(otherwise);
  scene::SelfRules& rules = choice.rules;
  rules.rings = options.rings.value_or(rules.rings);
  rules.drops_at_rest = options.drops_at_rest.value_or(poses_anything(scene));
  if (options.always && *options.always > 0) rules.always = options.always;
  choice.is_always_chosen = options.always.has_value();
  rules.drops_near_joints = options.drops_near_joints.value_or(rules.drops_near_joints);
  return choice;
}

scenes::SelfOptions without_defaults(const SelfChoice& choice) {
  scenes::SelfOptions options;
  options.wanted = choice.wanted;
  if (!choice.asks_self()) return options;
  options.rings = choice.rules.rings;
  options.drops_at_rest = choice.rules.drops_at_rest;
  options.always = choice.rules.always.value_or(0);
  options.drops_near_joints = choice.rules.drops_near_joints;
  return options;
}

bool is_one_body(const scenes::Scene& scene, scene::Granularity granularity) {
  if (scene.instances.size() != 1) return false;
  if (granularity == scene::Granularity::instance) return true;
  const std::vector<asset::Part>& parts =
      scene.characters[scene.instances[0].character].asset.parts;
  return std::count_if(parts.begin(), parts.end(),
                       [](const asset::Part& part) { return part.triangle_count > 0; }) == 1;
}

}  // namespace pelt::tools::check
