#include "tools/pelt/check/settings.hpp"

#include "scenes/ignored_pairs.hpp"
#include "scenes/names.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/scene/query_arguments.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <map>
#include <tuple>
#include <utility>

namespace pelt::tools::check {
namespace {

Result<methods::MethodKind> choose_method(const std::string& name, methods::MethodKinds known) {
  if (const auto method = methods::find_method(known, name)) return *method;
  return Error{ErrorCode::invalid_argument, "--method: unknown method " + text::quoted(name) +
                                                text::suggestion(name, methods::names_of(known))};
}

bool contains(const arguments::FrameRange& range, std::uint32_t frame) {
  return frame >= range.begin && frame < range.end && (frame - range.begin) % range.stride == 0;
}

/// Precondition: `settings` has its frames.
Result<void> check_glb_frame(const CheckSettings& settings) {
  const CheckOptions& options = settings.options;
  if (!options.glb_frame || contains(settings.frames, *options.glb_frame)) return {};
  return text::bad_argument("--glb-frame",
                            std::to_string(*options.glb_frame) + " is not a checked frame",
                            "choose a frame of --frames");
}

template <typename T>
Result<void> without_value(const Result<T>& result) {
  if (!result) return result.error();
  return {};
}

Result<void> check_clearance(const std::optional<double>& clearance) {
  if (!clearance || (*clearance >= 0 && *clearance <= 1e12)) return {};
  return text::number_not_allowed("--clearance", *clearance, "give a number from 0 to 1e12");
}

Result<std::optional<std::uint32_t>> choose_substeps(const CheckOptions& options) {
  using Substeps = std::optional<std::uint32_t>;
  if (options.between) return Substeps(options.substeps.value_or(1));
  if (!options.substeps) return Substeps();
  return text::bad_argument("--substeps", "requires --between", "give both");
}

Result<void> check_frames(const std::string& frames) {
  if (frames.empty()) return {};
  return without_value(arguments::parse_frame_range(frames));
}

Result<void> require_glb(const CheckOptions& options) {
  if (!options.glb_frame || !options.glb.empty()) return {};
  return text::bad_argument("--glb-frame", "requires --glb", "name the output with --glb FILE");
}

using scenes::SelfContacts;

Result<std::optional<SelfContacts>> parse_wanted(const std::string& text) {
  using Wanted = std::optional<SelfContacts>;
  if (text.empty()) return Wanted();
  if (text == "yes") return Wanted(SelfContacts::beside);
  if (text == "no") return Wanted(SelfContacts::none);
  if (text == "only") return Wanted(SelfContacts::only);
  return text::bad_argument("--self", "unknown value " + text::quoted(text),
                            "give --self, --self=only or --self=no");
}

/// Parses "keep" or "drop".
Result<std::optional<bool>> parse_drops(const char* option, const std::string& text) {
  if (text.empty()) return std::optional<bool>();
  if (text == "keep" || text == "drop") return std::optional<bool>(text == "drop");
  return text::bad_argument(option, "unknown value " + text::quoted(text), "give keep or drop");
}

Result<std::optional<double>> parse_always(const std::string& text) {
  if (text.empty()) return std::optional<double>();
  if (text == "keep") return std::optional<double>(0);
  double share = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, share);
  if (error == std::errc() && read == end && share > 0 && share <= 1)
    return std::optional<double>(share);
  return text::bad_argument("--self-always", "unknown value " + text::quoted(text),
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

/// Validates the options.
Result<scenes::SelfOptions> parse_self(const CheckOptions& options) {
  const auto wanted = parse_wanted(options.self);
  const auto at_rest = parse_drops("--self-at-rest", options.self_at_rest);
  const auto always = parse_always(options.self_always);
  const auto near_joints = parse_drops("--self-near-joints", options.self_near_joints);
  for (const Error* error :
       {error_of(wanted), error_of(at_rest), error_of(always), error_of(near_joints)})
    if (error) return *error;
  return scenes::SelfOptions{*wanted, options.self_rings, *at_rest, *always, *near_joints};
}

/// Fills in the defaults. `otherwise` is the default of --self. Contacts at rest count by default
/// if the scene has no other poses, because otherwise nothing could be found.
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

/// Whether the scene has only one collider, so that the contacts with itself are its only ones.
bool is_one_body(const scenes::Scene& scene, scene::Granularity granularity) {
  if (scene.instances.size() != 1) return false;
  if (granularity == scene::Granularity::instance) return true;
  const std::vector<asset::Part>& parts =
      scene.characters[scene.instances[0].character].asset.parts;
  return std::count_if(parts.begin(), parts.end(),
                       [](const asset::Part& part) { return part.triangle_count > 0; }) == 1;
}

/// Precondition: `settings` has its method and granularity.
Result<SelfChoice> choose_self(const CheckSettings& settings, const scenes::Scene& scene) {
  const Result<scenes::SelfOptions> given = parse_self(settings.options);
  if (!given) return given.error();
  const Result<void> possible = check_conflicts(settings.options, "--self");
  const bool by_default = is_one_body(scene, settings.granularity) && possible;
  const SelfChoice choice =
      with_defaults(scenes::chosen_first(*given, scene.self), scene,
                    by_default ? scenes::SelfContacts::beside : scenes::SelfContacts::none);
  if (choice.asks_self() && !possible) return possible.error();
  return choice;
}

/// Parses "A,B"; the last comma separates the names.
Result<scenes::NamePair> parse_name_pair(const std::string& text) {
  const std::size_t comma = text.rfind(',');
  if (comma != std::string::npos && comma > 0 && comma + 1 < text.size())
    return scenes::NamePair{text.substr(0, comma), text.substr(comma + 1)};
  return text::bad_argument("--ignore", text::quoted(text) + " is not a pair of names",
                            "give two parts or joints, as in --ignore cape,spine");
}

/// Whether all parts are read. Otherwise, rules of a scene may match parts that are left out.
bool is_read_whole(const arguments::ModelArguments& models) {
  return models.exclude.empty() && !models.no_unskinned;
}

Result<std::vector<scenes::NamePair>> parse_ignored(const std::vector<std::string>& texts) {
  std::vector<scenes::NamePair> pairs;
  for (const std::string& text : texts) {
    const auto pair = parse_name_pair(text);
    if (!pair) return pair.error();
    pairs.push_back(*pair);
  }
  return pairs;
}

Result<std::vector<scenes::NamePair>> choose_ignored(const CheckOptions& options,
                                                     const scenes::Scene& scene) {
  const std::vector<const scenes::Character*> characters = scenes::characters_of(scene);
  auto pairs = parse_ignored(options.ignore);
  if (!pairs) return pairs.error();
  if (const auto known = scenes::check_names(characters, *pairs); !known)
    return text::prefixed("--ignore", known.error());
  if (const auto known = scenes::check_names(characters, scene.ignore);
      !known && is_read_whole(options.scene.models))
    return text::prefixed(scene.name + ": ignore", known.error());
  pairs->insert(pairs->begin(), scene.ignore.begin(), scene.ignore.end());
  if (pairs->empty()) return pairs;
  if (const auto checked = check_conflicts(options, kIgnoredPairs); !checked)
    return checked.error();
  return pairs;
}

/// Props that stick into a character hide the contacts of its skin. Does nothing for a model
/// without any skin.
void note_unskinned(const SelfChoice& self, scenes::Scene& scene) {
  if (!self.asks_self() || scene.instances.size() != 1) return;
  constexpr std::size_t kNamed = 3;
  const asset::Asset& asset = scene.characters[scene.instances[0].character].asset;
  const std::vector<std::string> names = scenes::part_names(asset);
  std::size_t count = 0;
  std::string list;
  for (std::size_t p = 0; p < names.size(); ++p) {
    if (asset.parts[p].skinned || asset.parts[p].triangle_count == 0) continue;
    if (count++ < kNamed) list += (list.empty() ? "" : ", ") + text::printable_name(names[p]);
  }
  if (count == 0 || count == names.size()) return;
  scene.notes.push_back(text::counted(count, "part") + (count == 1 ? " is" : " are") +
                        " not skinned (" + list + (count > kNamed ? ", ..." : "") +
                        "): --no-unskinned leaves " + (count == 1 ? "it" : "them") + " out");
}

Result<CheckBaseline> read_baseline(const CheckSettings& settings, const scenes::Scene& scene) {
  const auto& [path, text] = std::tie(settings.options.baseline, settings.options.baseline_text);
  const nlohmann::ordered_json question = question_json(settings, scene);
  if (!text) return CheckBaseline::read(path, question, scene);
  if (text->empty()) return CheckBaseline();
  return CheckBaseline::parse(path, *text, question, scene);
}

/// Precondition: `settings` is complete except for `baseline`.
Result<std::optional<CheckBaseline>> choose_baseline(const CheckSettings& settings,
                                                     const scenes::Scene& scene) {
  if (settings.options.baseline.empty()) return std::optional<CheckBaseline>();
  Result<CheckBaseline> known = read_baseline(settings, scene);
  if (!known) return known.error();
  return std::optional<CheckBaseline>(std::move(*known));
}

Result<FailOn> choose_fail_on(const CheckOptions& options) {
  if (options.fail_on.empty()) return options.baseline.empty() ? FailOn::contact : FailOn::grown;
  const auto fail_on = find_fail_on(options.fail_on);
  if (!fail_on)
    return text::bad_argument("--fail-on", "unknown value " + text::quoted(options.fail_on),
                              "give contact, between, grown, new, unknown or never");
  if (*fail_on == FailOn::unknown && !options.budget)
    return text::bad_argument("--fail-on", "unknown requires a limit of the work",
                              "give one with --budget WORK");
  if (*fail_on == FailOn::between && !options.between)
    return text::bad_argument("--fail-on", "between requires --between", "give both");
  const bool needs_baseline = *fail_on == FailOn::grown || *fail_on == FailOn::newly;
  if (needs_baseline && options.baseline.empty())
    return text::bad_argument("--fail-on", options.fail_on + " requires a baseline",
                              "give an earlier answer with --baseline FILE");
  return *fail_on;
}

/// Collects choices and stores the first error.
class Choices {
 public:
  template <typename T>
  void take(Result<T> chosen, T& value) {
    if (chosen)
      value = std::move(*chosen);
    else
      require(chosen.error());
  }

  void require(const Result<void>& checked) {
    if (!checked && !refusal_) refusal_ = checked.error();
  }

  const std::optional<Error>& refusal() const { return refusal_; }

 private:
  std::optional<Error> refusal_;
};

/// Validates all options, and chooses what does not depend on the scene.
Result<CheckSettings> choose_without_scene(const CheckOptions& options) {
  CheckSettings settings;
  settings.options = options;
  settings.max_contacts = options.first ? 1 : options.max_contacts;
  Choices choices;
  choices.take(choose_method(options.method, options.known_methods), settings.method);
  choices.require(check_clearance(options.clearance));
  choices.require(check_conflicts(options));
  choices.take(choose_substeps(options), settings.substeps);
  choices.take(scene::choose_granularity(options.by), settings.granularity);
  choices.require(without_value(parse_self(options)));
  choices.require(check_frames(options.frames));
  choices.require(arguments::check_fps(options.scene.fps));
  choices.require(without_value(parse_ignored(options.ignore)));
  choices.require(require_glb(options));
  choices.take(choose_fail_on(options), settings.fail_on);
  if (choices.refusal()) return *choices.refusal();
  return settings;
}

using nlohmann::ordered_json;

/// Null if bodies are not tested against themselves.
ordered_json self_json(const SelfChoice& self) {
  if (!self.asks_self()) return nullptr;
  const auto kept_or_dropped = [](bool drops) { return drops ? "drop" : "keep"; };
  ordered_json object = {{"only", !self.asks_pairs()},
                         {"rings", self.rules.rings},
                         {"at_rest", kept_or_dropped(self.rules.drops_at_rest)},
                         {"always", "keep"},
                         {"near_joints", kept_or_dropped(self.rules.drops_near_joints)}};
  if (self.rules.always) object["always"] = *self.rules.always;
  return object;
}

/// The kind of skinning of all models, or of each model if they differ.
ordered_json skinning_json(const arguments::ModelArguments& models, const scenes::Scene& scene) {
  std::map<std::string, std::string> skinning;
  for (const scenes::Character& character : scene.characters)
    skinning[character.name] = scenes::name_of(models.skinning_of(character));
  if (skinning.empty()) return scenes::name_of(Skinning::linear);
  const std::string& first = skinning.begin()->second;
  const bool differ = std::any_of(skinning.begin(), skinning.end(),
                                  [&](const auto& model) { return model.second != first; });
  return differ ? ordered_json(skinning) : ordered_json(first);
}

}  // namespace

Result<void> check_options(const CheckOptions& options) {
  return without_value(choose_without_scene(options));
}

Result<CheckSettings> choose_settings(const CheckOptions& options, scenes::Scene& scene) {
  Result<CheckSettings> settings = choose_without_scene(options);
  if (!settings) return settings;
  Choices choices;
  choices.take(choose_self(*settings, scene), settings->self);
  choices.take(arguments::choose_frames(options.frames, options.scene, scene), settings->frames);
  choices.take(choose_ignored(options, scene), settings->ignore);
  choices.require(check_glb_frame(*settings));
  choices.take(choose_baseline(*settings, scene), settings->baseline);
  if (choices.refusal()) return *choices.refusal();
  note_unskinned(settings->self, scene);
  return settings;
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

nlohmann::ordered_json question_json(const CheckSettings& settings, const scenes::Scene& scene) {
  const CheckOptions& options = settings.options;
  const arguments::ModelArguments& models = options.scene.models;
  const auto [begin, end, stride] = settings.frames;
  ordered_json header = {
      {"method", settings.method.name},
      {"by", settings.granularity == scene::Granularity::part ? "part" : "instance"},
      {"frames", {begin, end, stride}},
      {"fps", scene.fps},
      {"max_contacts", nullptr},
      {"pairs", options.pairs},
      {"contacts", options.contacts},
      {"inside", options.inside},
      {"clearance", nullptr},
      {"between", nullptr},
      {"self", self_json(settings.self)},
      {"ignore", ordered_json::array()},
      {"exclude", models.exclude},
      {"no_unskinned", models.no_unskinned},
      {"renormalise", models.renormalise},
      {"skinning", skinning_json(models, scene)}};
  for (const scenes::NamePair& pair : settings.ignore) header["ignore"].push_back({pair.a, pair.b});
  for (const scenes::Take& take : scene.takes) header["clips"].push_back(take.clip);
  if (options.clearance) header["clearance"] = *options.clearance;
  if (settings.substeps) header["between"] = {{"substeps", *settings.substeps}};
  if (settings.max_contacts) header["max_contacts"] = *settings.max_contacts;
  add_stated(options, header);
  return header;
}

}  // namespace pelt::tools::check
