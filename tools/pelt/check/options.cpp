#include "tools/pelt/check/options.hpp"

#include "text/message.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/json_fields.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <type_traits>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

/// The subject of an option.
enum class Kind {
  list,      ///< which scenes are checked, one by one
  question,  ///< the answers of frames
  verdict,   ///< what is made of the answers; has the conflicts of kVerdict
  output,    ///< what is written
  machine,   ///< how the answers are computed; they do not depend on it
  shard,     ///< which share of the answers is computed
};

/// Whether an option stands in the header of the answer as it is, if it is given.
enum class Header { by_own_rule, if_given };

template <typename T>
struct Row {
  const char* name;
  T CheckOptions::*value;
  Kind kind;
  const char* help;
  arguments::OptionSyntax syntax;
  Header header;
};

template <typename T>
constexpr Row<T> row(const char* name, T CheckOptions::*value, Kind kind, const char* help,
                     const arguments::OptionSyntax& syntax = {},
                     Header header = Header::by_own_rule) {
  return {name, value, kind, help, syntax, header};
}

constexpr const char* kSelfGroup = "Contacts of a character with itself";

/// In the order of --help. The help of --method ends with the known methods, and that of --simd is
/// shared with other verbs.
constexpr auto kRows = std::make_tuple(
    row("--scenes", &CheckOptions::scenes, Kind::list,
        "Check each scene or model of a list, a text file with one name per line",
        {.type = "FILE"}),
    row("--frames", &CheckOptions::frames, Kind::question,
        "Frames A to B - 1; with A:B:S every S-th of them (default: all frames of the scene or "
        "of the longest clip)",
        {.type = "A:B"}),
    row("--by", &CheckOptions::by, Kind::question,
        "What is tested: every two instances, or every two parts, including parts of the same "
        "instance",
        {.type = "instance|part"}),
    row("--method", &CheckOptions::method, Kind::question, "One of ", {.type = "NAME"}),
    row("--simd", &CheckOptions::simd, Kind::machine, ""),
    row("--threads", &CheckOptions::threads, Kind::machine,
        "Query frames on N threads (default: one per core); the answer does not depend on it",
        {.type = "N", .least = 1, .most = 1024}),
    row("--first", &CheckOptions::first, Kind::question,
        "Stop at the first contact of each pair in each frame"),
    row("--max-contacts", &CheckOptions::max_contacts, Kind::question,
        "Stop after N contacts of each pair in each frame",
        {.type = "N", .least = 1, .excludes = "--first"}),
    row("--self", &CheckOptions::self, Kind::question,
        "Also test each character against itself; only: test nothing else (default: yes for "
        "a single character, no for several)",
        {.type = "yes|only|no"}),
    row("--self-rings", &CheckOptions::self_rings, Kind::question,
        "Drop contacts of triangles that are at most K steps apart, each step to a triangle "
        "that shares a corner; 0 drops nothing (default: 5)",
        {.type = "K", .most = scenes::kMaxSelfRings, .group = kSelfGroup}),
    row("--self-at-rest", &CheckOptions::self_at_rest, Kind::question,
        "Contacts that the character also has in its rest pose or default pose (default: "
        "drop; keep if no instance plays a clip or sets morph weights)",
        {.type = "keep|drop", .group = kSelfGroup}),
    row("--self-always", &CheckOptions::self_always, Kind::question,
        "Drop contacts of triangles that intersect in at least this share of the checked "
        "frames, such as 0.95 (default: keep)",
        {.type = "SHARE|keep", .group = kSelfGroup}),
    row("--self-near-joints", &CheckOptions::self_near_joints, Kind::question,
        "Contacts of triangles whose main joints are the same or neighbours; of neighbours "
        "that share skin, only contacts near their joint (default: drop)",
        {.type = "keep|drop", .group = kSelfGroup}),
    row("--ignore", &CheckOptions::ignore, Kind::question,
        "Do not count contacts between two parts or joints (repeatable)", {.type = "A,B"}),
    row("--baseline", &CheckOptions::baseline, Kind::verdict,
        "Compare with the --jsonl output of an earlier check; fail only if parts or joints touch "
        "that did not touch before, or have more contacts in their worst frame than before",
        {.type = "FILE"}),
    row("--fail-on", &CheckOptions::fail_on, Kind::verdict,
        "What sets the exit code to 1 (default: contact; with --baseline: grown)",
        {.type = "contact|between|grown|new|unknown|never"}),
    row("--allow-empty", &CheckOptions::allow_empty, Kind::verdict,
        "Accept a check that has nothing to test, such as one of a single instance with --self no "
        "(otherwise exit code 2)"),
    row("--list", &CheckOptions::list, Kind::output,
        "Show at most N rows of each list in the summary", {.type = "N", .least = 1}),
    row("--jsonl", &CheckOptions::jsonl, Kind::output,
        "Write the answer, one JSON object per line; -: to standard output, with the summary "
        "on standard error",
        {.type = "FILE"}),
    row("--pairs", &CheckOptions::pairs, Kind::question,
        "Also write the triangle pairs, not only their number"),
    row("--contacts", &CheckOptions::contacts, Kind::question,
        "Describe how the triangles intersect: segments, curves, patches (connected sets of "
        "contacts), normals, depths, joints"),
    row("--inside", &CheckOptions::inside, Kind::question,
        "For closed surfaces, also report contained bodies and, where surfaces touch, the "
        "depth of the deepest vertex; compares different instances (or parts) only"),
    row("--clearance", &CheckOptions::clearance, Kind::question,
        "Find all pairs of triangles at most DISTANCE apart, not only those that touch",
        {.type = "DISTANCE"}),
    row("--budget", &CheckOptions::budget, Kind::question,
        "Limit the work of each pair in each frame, in units of about one test of two "
        "triangles, and report what is not decided",
        {.type = "WORK", .least = 1}, Header::if_given),
    row("--between", &CheckOptions::between, Kind::question,
        "Also test each step from one frame to the next, with vertices that move in straight "
        "lines: find triangles that touch between frames and in neither frame, when first, "
        "and which corners, edges or faces meet"),
    row("--substeps", &CheckOptions::substeps, Kind::question,
        "Divide each step of --between into K straight pieces, with poses of the clips at "
        "their ends (default: 1)",
        {.type = "K", .least = 1, .most = 1000}),
    row("--html", &CheckOptions::html, Kind::output,
        "Write a self-contained page that plays the scene and finds its contacts",
        {.type = "FILE"}),
    row("--glb", &CheckOptions::glb, Kind::output,
        "Write the posed characters of the worst frame, with intersecting triangles coloured",
        {.type = "FILE"}),
    row("--glb-frame", &CheckOptions::glb_frame, Kind::output, "Write this frame to --glb",
        {.type = "N"}),
    row("--shard", &CheckOptions::shard, Kind::shard,
        "Query only the I-th of N shares of the frames (with --scenes: of the scenes), from "
        "1/N to N/N, and write them to -o, for pelt merge",
        {.type = "I/N"}),
    row("-o", &CheckOptions::shard_file, Kind::shard, "The file of the shard", {.type = "FILE"}));

/// An option that cannot be combined with another one, or with what is true beside the options.
struct Conflict {
  const char *option, *with, *remedy;
  const char* problem = nullptr;  ///< instead of "cannot be combined with"
  const char* unless = nullptr;   ///< an option with which the two can be combined
};

constexpr const char* kVerdict = "any option of the verdict";
constexpr const char* kOneOfTwo = "give one of the two";
constexpr const char* kAlone = "check that scene alone";
constexpr const char* kToMerge = "give it to pelt merge";
constexpr const char* kToShards = "give it to each pelt check --shard";
constexpr const char* kLeaveOut = "leave it out";
constexpr const char* kOnDemand = "requires the method on_demand";
constexpr const char* kNoMethod = "leave out --method";
constexpr const char* kAllContacts = "requires all contacts";
constexpr const char* kNoLimit = "leave out --first and --max-contacts";

/// All are checked. Of several conflicts, the first one is reported. A list is judged scene by
/// scene, while the scene is loaded, so its shards have the options of the verdict.
constexpr Conflict kConflicts[] = {
    {"--jsonl", "--shard", kToMerge},
    {"--glb", "--shard", kToMerge},
    {"--glb-frame", "--shard", kToMerge},
    {"--html", "--shard", kToMerge},
    {kVerdict, "--shard", kToMerge, nullptr, "--scenes"},
    {"--html", "--scenes", kAlone},
    {"--glb", "--scenes", kAlone},
    {"--glb-frame", "--scenes", kAlone},
    {kVerdict, kShardsOfList, kToShards},
    {"--html", kShardsOfList, kAlone},
    {"--glb", kShardsOfList, kAlone},
    {"--glb-frame", kShardsOfList, kAlone},
    {"--clearance", "--method", kNoMethod, kOnDemand},
    {"--clearance", "--contacts", kOneOfTwo},
    {"--clearance", "--inside", kOneOfTwo},
    {"--budget", "--method", kNoMethod, kOnDemand},
    {"--budget", "--clearance", kOneOfTwo},
    {"--budget", "--inside", kOneOfTwo},
    {"--budget", "--first", kOneOfTwo},
    {"--budget", "--max-contacts", kOneOfTwo},
    {"--budget", "--baseline", kOneOfTwo},
    {"--between", "--method", kOneOfTwo},
    {"--between", "--clearance", kOneOfTwo},
    {"--between", "--budget", kOneOfTwo},
    {"--between", "--first", kOneOfTwo},
    {"--between", "--max-contacts", kOneOfTwo},
    {"--self", "--method", kOneOfTwo},
    {"--self", "--clearance", kOneOfTwo},
    {"--self", "--budget", kOneOfTwo},
    {"--first", kIgnoredPairs, kLeaveOut},
    {"--max-contacts", kIgnoredPairs, kLeaveOut},
    {"--baseline", "--first", kNoLimit, kAllContacts},
    {"--baseline", "--max-contacts", kNoLimit, kAllContacts},
};

constexpr bool is_known(std::string_view name) {
  const auto is_row = [&](const auto&... rows) { return ((name == rows.name) || ...); };
  return name == kVerdict || name == kShardsOfList || name == kIgnoredPairs ||
         std::apply(is_row, kRows);
}

static_assert(std::all_of(std::begin(kConflicts), std::end(kConflicts), [](const Conflict& row) {
  return is_known(row.option) && is_known(row.with) && (!row.unless || is_known(row.unless));
}));

template <typename Visit>
void each_row(const Visit& visit) {
  std::apply([&](const auto&... rows) { (visit(rows), ...); }, kRows);
}

template <typename T>
void add_option(arguments::Verb& verb, const Row<T>& row, CheckOptions& options) {
  T& value = options.*row.value;
  const std::string_view name = row.name;
  if constexpr (std::is_same_v<T, bool>) {
    verb.flag(row.name, value, row.help);
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (name == "--simd")
      arguments::add_simd_option(verb, value);
    else if (name == "--self")
      verb.choice(row.name, value, row.syntax.type, row.help);
    else
      verb.option(row.name, value,
                  row.help + (name == "--method" ? methods::listed(options.known_methods) : ""),
                  row.syntax);
  } else {
    verb.option(row.name, value, row.help, row.syntax);
  }
}

/// "max_contacts" for "--max-contacts".
std::string key_of(std::string_view name) {
  std::string key(name.substr(name.find_first_not_of('-')));
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

template <typename T>
bool is_given(const Row<T>& row, const CheckOptions& options) {
  static const CheckOptions kDefaults;
  return options.*row.value != kDefaults.*row.value;
}

/// The name of the first option that is given and that `matches`, or null.
template <typename Matches>
const char* find_given(const CheckOptions& options, const Matches& matches) {
  const char* found = nullptr;
  each_row([&](const auto& row) {
    if (found == nullptr && matches(row.name, row.kind) && is_given(row, options)) found = row.name;
  });
  return found;
}

/// The option that a side of a conflict names, or null if it is not given. --self no asks for
/// nothing.
const char* find_given(std::string_view name, const CheckOptions& options) {
  if (name == kVerdict)
    return find_given(options, [](const char*, Kind kind) { return kind == Kind::verdict; });
  if (name == "--self" && options.self == "no") return nullptr;
  if (name == kIgnoredPairs) name = "--ignore";
  return find_given(options, [name](const char* other, Kind) { return name == other; });
}

/// Calls `visit` with the key and the value of each option that the answers of frames or the
/// verdict depend on.
template <typename Options, typename Visit>
void visit_answer_options(Options& of, const Visit& visit) {
  const auto visit_rows = [&](auto has_kind) {
    each_row([&](const auto& row) {
      if (has_kind(row.kind)) visit(key_of(row.name), of.*row.value);
    });
  };
  visit("inputs", of.scene.inputs);
  visit_rows([](Kind kind) { return kind == Kind::list; });
  visit("clip", of.scene.clips);
  visit("start", of.scene.starts);
  visit("at", of.scene.positions);
  visit("turn", of.scene.turns);
  visit("scale", of.scene.scales);
  visit("fps", of.scene.fps);
  visit("no_unskinned", of.scene.models.no_unskinned);
  visit("exclude", of.scene.models.exclude);
  visit("renormalise", of.scene.models.renormalise);
  visit("skinning", of.scene.models.skinning);
  visit("samples", of.scene.models.samples);
  visit_rows([](Kind kind) { return kind == Kind::question; });
  visit_rows([](Kind kind) { return kind == Kind::verdict; });
}

}  // namespace

void add_check_options(arguments::Verb& verb, CheckOptions& options) {
  arguments::add_scene_options(verb, options.scene, arguments::InputsNeeded::none);
  each_row([&](const auto& row) { add_option(verb, row, options); });
}

void add_outcome_options(arguments::Verb& verb, CheckOptions& options) {
  each_row([&](const auto& row) {
    if (row.kind == Kind::verdict || row.kind == Kind::output) add_option(verb, row, options);
  });
}

void copy_outcome(const CheckOptions& from, CheckOptions& to) {
  each_row([&](const auto& row) {
    if (row.kind == Kind::verdict || row.kind == Kind::output || row.kind == Kind::machine)
      to.*row.value = from.*row.value;
  });
  to.words = from.words;
}

Result<void> check_conflicts(const CheckOptions& options, std::string_view also) {
  const auto find = [&](const char* name) {
    return name == also ? name : find_given(name, options);
  };
  for (const auto& [option, with, remedy, problem, unless] : kConflicts) {
    const char* const given = find(option);
    if (given == nullptr || find(with) == nullptr) continue;
    if (unless != nullptr && find(unless) != nullptr) continue;
    return text::bad_argument(
        given, problem ? problem : std::string("cannot be combined with ") + with, remedy);
  }
  return {};
}

ordered_json arguments_json(const CheckOptions& options) {
  ordered_json object;
  visit_answer_options(
      options, [&](const std::string& key, const auto& value) { object[key] = to_json(value); });
  return object;
}

bool has_known_options(const nlohmann::json& json) {
  const ordered_json known = arguments_json({});
  return json.size() == known.size() &&
         std::all_of(known.items().begin(), known.items().end(),
                     [&](const auto& option) { return json.contains(option.key()); });
}

bool read_options(const nlohmann::json& object, CheckOptions& options) {
  bool is_good = object.is_object();
  visit_answer_options(options, [&](const std::string& key, auto& value) {
    const auto found = is_good ? object.find(key) : object.end();
    is_good = is_good && found != object.end() && read(*found, value);
  });
  return is_good && options.scene.inputs.empty() != options.scenes.empty();
}

void add_stated(const CheckOptions& options, ordered_json& header) {
  each_row([&](const auto& row) {
    if (row.header == Header::if_given && is_given(row, options))
      header[key_of(row.name)] = to_json(options.*row.value);
  });
}

std::vector<std::string> stated_keys() {
  std::vector<std::string> keys;
  each_row([&](const auto& row) {
    if (row.header == Header::if_given) keys.push_back(key_of(row.name));
  });
  return keys;
}

}  // namespace pelt::tools::check
