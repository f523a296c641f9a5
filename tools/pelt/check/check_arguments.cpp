#include "tools/pelt/check/check_arguments.hpp"

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "scenes/closest_name.hpp"
#include "scenes/ignored_pairs.hpp"
#include "scenes/names.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/query_arguments.hpp"

#include <tuple>
#include <utility>

namespace pelt::tools::check {
namespace {

Result<methods::MethodKind> choose_method(const std::string& name, methods::MethodKinds known) {
  if (const auto method = methods::find_method(known, name)) return *method;
  return Error{ErrorCode::invalid_argument, "--method: unknown method " + asset::quoted(name) +
                                                scenes::suggestion(name, methods::names_of(known))};
}

bool contains(const arguments::FrameRange& range, std::uint32_t frame) {
  return frame >= range.begin && frame < range.end && (frame - range.begin) % range.stride == 0;
}

Result<std::optional<std::uint32_t>> choose_glb_frame(const CheckArguments& arguments,
                                                      const arguments::FrameRange& frames) {
  if (!arguments.glb_frame) return arguments.glb_frame;
  if (arguments.glb.empty()) {
    return output::bad_argument("--glb-frame", "requires --glb", "name the output with --glb FILE");
  }
  if (contains(frames, *arguments.glb_frame)) return arguments.glb_frame;
  return output::bad_argument("--glb-frame",
                              std::to_string(*arguments.glb_frame) + " is not a checked frame",
                              "choose a frame of --frames");
}

Result<std::optional<double>> choose_clearance(const CheckArguments& arguments,
                                               methods::MethodKind method) {
  if (!arguments.clearance) return arguments.clearance;
  if (!(*arguments.clearance >= 0 && *arguments.clearance <= 1e12))
    return output::number_not_allowed("--clearance", *arguments.clearance,
                                      "give a number from 0 to 1e12");
  if (method != methods::kOnDemand)
    return output::bad_argument("--clearance", "requires the method on_demand",
                                "leave out --method");
  if (arguments.contacts)
    return output::bad_argument("--clearance", "cannot be combined with --contacts",
                                "give one of the two");
  if (arguments.inside)
    return output::bad_argument("--clearance", "cannot be combined with --inside",
                                "give one of the two");
  return arguments.clearance;
}

/// Returns the first given option that cannot be combined with --budget, or null.
const char* excluded_by_budget(const CheckArguments& arguments) {
  if (arguments.clearance) return "--clearance";
  if (arguments.inside) return "--inside";
  if (arguments.first) return "--first";
  if (arguments.max_contacts) return "--max-contacts";
  if (!arguments.baseline.empty()) return "--baseline";
  return nullptr;
}

Result<std::optional<std::uint32_t>> choose_budget(const CheckArguments& arguments,
                                                   methods::MethodKind method) {
  if (!arguments.budget) return arguments.budget;
  if (method != methods::kOnDemand)
    return output::bad_argument("--budget", "requires the method on_demand", "leave out --method");
  if (const char* const excluded = excluded_by_budget(arguments))
    return output::bad_argument("--budget", std::string("cannot be combined with ") + excluded,
                                "give one of the two");
  return arguments.budget;
}

/// Returns the option that cannot be combined with --between, or null.
const char* excludes_between(const CheckArguments& arguments, methods::MethodKind method) {
  if (method != methods::kOnDemand) return "--method";
  if (arguments.clearance) return "--clearance";
  if (arguments.budget) return "--budget";
  if (arguments.first) return "--first";
  if (arguments.max_contacts) return "--max-contacts";
  return nullptr;
}

Result<std::optional<std::uint32_t>> choose_substeps(const CheckArguments& arguments,
                                                     methods::MethodKind method) {
  using Substeps = std::optional<std::uint32_t>;
  if (!arguments.between && !arguments.substeps) return Substeps();
  if (!arguments.between)
    return output::bad_argument("--substeps", "requires --between", "give both");
  if (const char* const option = excludes_between(arguments, method))
    return output::bad_argument("--between", std::string("cannot be combined with ") + option,
                                "give one of the two");
  return Substeps(arguments.substeps.value_or(1));
}

/// Returns the option that excludes tests of bodies against themselves, or null.
const char* excluded_by(const CheckSettings& settings) {
  if (settings.method != methods::kOnDemand) return "--method";
  if (settings.clearance) return "--clearance";
  if (settings.budget) return "--budget";
  return nullptr;
}

/// Precondition: `settings` has its method, clearance, substeps and granularity.
Result<SelfChoice> choose_self(const CheckArguments& arguments, const CheckSettings& settings,
                               const scenes::Scene& scene) {
  const Result<scenes::SelfOptions> given = parse_self(arguments.self);
  if (!given) return given.error();
  const char* const excluded = excluded_by(settings);
  const bool by_default = is_one_body(scene, settings.granularity) && excluded == nullptr;
  const SelfChoice choice =
      with_defaults(scenes::chosen_first(*given, scene.self), scene,
                    by_default ? scenes::SelfContacts::beside : scenes::SelfContacts::none);
  if (choice.asks_self() && excluded != nullptr)
    return output::bad_argument("--self", std::string("cannot be combined with ") + excluded,
                                "give one of the two");
  return choice;
}

/// Parses "A,B"; the last comma separates the names.
Result<scenes::NamePair> parse_name_pair(const std::string& text) {
  const std::size_t comma = text.rfind(',');
  if (comma != std::string::npos && comma > 0 && comma + 1 < text.size())
    return scenes::NamePair{text.substr(0, comma), text.substr(comma + 1)};
  return output::bad_argument("--ignore", asset::quoted(text) + " is not a pair of names",
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

Result<std::vector<scenes::NamePair>> choose_ignored(const CheckArguments& arguments,
                                                     const scenes::Scene& scene) {
  const std::vector<const scenes::Character*> characters = scenes::characters_of(scene);
  auto pairs = parse_ignored(arguments.ignore);
  if (!pairs) return pairs.error();
  if (const auto known = scenes::check_names(characters, *pairs); !known)
    return asset::prefixed("--ignore", known.error());
  if (const auto known = scenes::check_names(characters, scene.ignore);
      !known && is_read_whole(arguments.scene.models))
    return asset::prefixed(scene.name + ": ignore", known.error());
  pairs->insert(pairs->begin(), scene.ignore.begin(), scene.ignore.end());
  if (pairs->empty() || (!arguments.first && !arguments.max_contacts)) return *pairs;
  return output::bad_argument(
      arguments.first ? "--first" : "--max-contacts",
      "cannot be combined with ignored pairs, because the first contacts may be ignored ones",
      "leave it out");
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
    if (count++ < kNamed) list += (list.empty() ? "" : ", ") + asset::printable_name(names[p]);
  }
  if (count == 0 || count == names.size()) return;
  scene.notes.push_back(output::counted(count, "part") + (count == 1 ? " is" : " are") +
                        " not skinned (" + list + (count > kNamed ? ", ..." : "") +
                        "): --no-unskinned leaves " + (count == 1 ? "it" : "them") + " out");
}

Result<CheckBaseline> read_baseline(const CheckArguments& arguments, const CheckQuestion& question,
                                    const scenes::Scene& scene) {
  const auto& [path, text] = std::tie(arguments.baseline, arguments.baseline_text);
  if (!text) return CheckBaseline::read(path, question, scene);
  if (text->empty()) return CheckBaseline();
  return CheckBaseline::parse(path, *text, question, scene);
}

/// Precondition: `settings` is complete except for `baseline` and `fail_on`.
Result<std::optional<CheckBaseline>> choose_baseline(const CheckArguments& arguments,
                                                     const CheckSettings& settings,
                                                     const scenes::Scene& scene) {
  if (arguments.baseline.empty()) return std::optional<CheckBaseline>();
  if (settings.max_contacts)
    return output::bad_argument("--baseline", "requires all contacts",
                                "leave out --first and --max-contacts");
  const CheckQuestion question = question_of(settings, scene, arguments.scene.models);
  Result<CheckBaseline> known = read_baseline(arguments, question, scene);
  if (!known) return known.error();
  return std::optional<CheckBaseline>(std::move(*known));
}

Result<FailOn> choose_fail_on(const CheckArguments& arguments) {
  if (arguments.fail_on.empty())
    return arguments.baseline.empty() ? FailOn::contact : FailOn::grown;
  const auto fail_on = find_fail_on(arguments.fail_on);
  if (!fail_on)
    return output::bad_argument("--fail-on", "unknown value " + asset::quoted(arguments.fail_on),
                                "give contact, between, grown, new, unknown or never");
  if (*fail_on == FailOn::unknown && !arguments.budget)
    return output::bad_argument("--fail-on", "unknown requires a limit of the work",
                                "give one with --budget WORK");
  if (*fail_on == FailOn::between && !arguments.between)
    return output::bad_argument("--fail-on", "between requires --between", "give both");
  const bool needs_baseline = *fail_on == FailOn::grown || *fail_on == FailOn::newly;
  if (needs_baseline && arguments.baseline.empty())
    return output::bad_argument("--fail-on", arguments.fail_on + " requires a baseline",
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
    else if (!refusal_)
      refusal_ = chosen.error();
  }

  const std::optional<Error>& refusal() const { return refusal_; }

 private:
  std::optional<Error> refusal_;
};

/// Options of what is tested.
void add_test_options(arguments::Verb& verb, CheckArguments& arguments) {
  arguments::add_scene_options(verb, arguments.scene, arguments::InputsNeeded::none);
  verb.option("--scenes", arguments.scenes,
              "Check each scene or model of a list, a text file with one name per line",
              {.type = "FILE"});
  verb.option(
      "--frames", arguments.frames,
      "Frames A to B - 1; with A:B:S every S-th of them (default: all frames of the scene or "
      "of the longest clip)",
      {.type = "A:B"});
  verb.option(
      "--by", arguments.by,
      "What is tested: every two instances, or every two parts, including parts of the same "
      "instance",
      {.type = "instance|part"});
  verb.option("--method", arguments.method, "One of " + methods::listed(arguments.known_methods),
              {.type = "NAME"});
  arguments::add_simd_option(verb, arguments.simd);
  verb.option("--threads", arguments.threads,
              "Query frames on N threads (default: one per core); the answer does not depend on it",
              {.type = "N", .least = 1, .most = 1024});
  verb.flag("--first", arguments.first, "Stop at the first contact of each pair in each frame");
  verb.option("--max-contacts", arguments.max_contacts,
              "Stop after N contacts of each pair in each frame",
              {.type = "N", .least = 1, .excludes = "--first"});
  add_self_options(verb, arguments.self);
}

/// Options of the details of the answer.
void add_detail_options(arguments::Verb& verb, CheckArguments& arguments) {
  verb.flag("--pairs", arguments.pairs, "Also write the triangle pairs, not only their number");
  verb.flag("--contacts", arguments.contacts,
            "Describe how the triangles intersect: segments, curves, patches (connected sets of "
            "contacts), normals, depths, joints");
}

/// Options of questions other than which triangles touch in a frame.
void add_question_options(arguments::Verb& verb, CheckArguments& arguments) {
  verb.flag("--inside", arguments.inside,
            "For closed surfaces, also report contained bodies and, where surfaces touch, the "
            "depth of the deepest vertex; compares different instances (or parts) only");
  verb.option("--clearance", arguments.clearance,
              "Find all pairs of triangles at most DISTANCE apart, not only those that touch",
              {.type = "DISTANCE"});
  verb.option("--budget", arguments.budget,
              "Limit the work of each pair in each frame, in units of about one test of two "
              "triangles, and report what is not decided",
              {.type = "WORK", .least = 1});
  verb.flag("--between", arguments.between,
            "Also test each step from one frame to the next, with vertices that move in straight "
            "lines: find triangles that touch between frames and in neither frame, when first, "
            "and which corners, edges or faces meet");
  verb.option("--substeps", arguments.substeps,
              "Divide each step of --between into K straight pieces, with poses of the clips at "
              "their ends (default: 1)",
              {.type = "K", .least = 1, .most = 1000});
}

/// Options of runs that query only a share of the frames.
void add_shard_options(arguments::Verb& verb, CheckArguments& arguments) {
  verb.option("--shard", arguments.shard,
              "Query only the I-th of N shares of the frames (with --scenes: of the scenes), from "
              "1/N to N/N, and write them to -o, for pelt merge",
              {.type = "I/N"});
  verb.option("-o", arguments.shard_file, "The file of the shard", {.type = "FILE"});
}

}  // namespace

void add_check_options(arguments::Verb& verb, CheckArguments& arguments) {
  add_test_options(verb, arguments);
  verb.option("--ignore", arguments.ignore,
              "Do not count contacts between two parts or joints (repeatable)", {.type = "A,B"});
  add_verdict_options(verb, arguments);
  add_detail_options(verb, arguments);
  add_question_options(verb, arguments);
  add_picture_options(verb, arguments);
  add_shard_options(verb, arguments);
}

void add_verdict_options(arguments::Verb& verb, CheckArguments& arguments) {
  verb.option(
      "--baseline", arguments.baseline,
      "Compare with the --jsonl output of an earlier check; fail only if parts or joints touch "
      "that did not touch before, or have more contacts in their worst frame than before",
      {.type = "FILE"});
  verb.option("--fail-on", arguments.fail_on,
              "What sets the exit code to 1 (default: contact; with --baseline: grown)",
              {.type = "contact|between|grown|new|unknown|never"});
  verb.flag(
      "--allow-empty", arguments.allow_empty,
      "Accept a check that has nothing to test, such as one of a single instance with --self no "
      "(otherwise exit code 2)");
  verb.option("--list", arguments.list, "Show at most N rows of each list in the summary",
              {.type = "N", .least = 1});
  verb.option("--jsonl", arguments.jsonl,
              "Write the answer, one JSON object per line; -: to standard output, with the summary "
              "on standard error",
              {.type = "FILE"});
}

void add_picture_options(arguments::Verb& verb, CheckArguments& arguments) {
  verb.option("--html", arguments.html,
              "Write a self-contained page that plays the scene and finds its contacts",
              {.type = "FILE"});
  verb.option("--glb", arguments.glb,
              "Write the posed characters of the worst frame, with intersecting triangles coloured",
              {.type = "FILE"});
  verb.option("--glb-frame", arguments.glb_frame, "Write this frame to --glb", {.type = "N"});
}

Result<CheckSettings> choose_settings(const CheckArguments& arguments, scenes::Scene& scene) {
  CheckSettings settings;
  settings.lists_triangles = arguments.pairs;
  settings.describes_contacts = arguments.contacts;
  settings.asks_inside = arguments.inside;
  settings.allows_empty = arguments.allow_empty;
  settings.rows_listed = arguments.list;
  settings.threads = arguments.threads.value_or(0);
  settings.max_contacts = arguments.first ? 1 : arguments.max_contacts;
  Choices choices;
  choices.take(choose_method(arguments.method, arguments.known_methods), settings.method);
  choices.take(choose_clearance(arguments, settings.method), settings.clearance);
  choices.take(choose_budget(arguments, settings.method), settings.budget);
  choices.take(choose_substeps(arguments, settings.method), settings.substeps);
  choices.take(scene::choose_granularity(arguments.by), settings.granularity);
  choices.take(choose_self(arguments, settings, scene), settings.self);
  choices.take(arguments::choose_frames(arguments.frames, arguments.scene, scene), settings.frames);
  choices.take(choose_ignored(arguments, scene), settings.ignore);
  choices.take(choose_glb_frame(arguments, settings.frames), settings.frame_to_keep);
  choices.take(choose_fail_on(arguments), settings.fail_on);
  choices.take(choose_baseline(arguments, settings, scene), settings.baseline);
  if (choices.refusal()) return *choices.refusal();
  note_unskinned(settings.self, scene);
  return settings;
}

}  // namespace pelt::tools::check
