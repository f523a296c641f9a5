#include "tools/pelt/check/options.hpp"

#include "text/message.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/json_fields.hpp"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

/// What an option decides.
enum class Kind {
  list,      ///< which scenes are checked, one by one
  question,  ///< the answers of frames
  plain,     ///< likewise; stands in the header of the answer as it is, if it is given
  verdict,   ///< what is made of the answers
  output,    ///< what is written
  machine,   ///< how the answers are computed; they do not depend on it
  shard,     ///< which share of the answers is computed
};

bool is_question(Kind kind) { return kind == Kind::question || kind == Kind::plain; }

template <typename T>
struct Row {
  const char* name;
  T CheckOptions::*value;
  Kind kind;
  const char* help;
  arguments::OptionSyntax syntax;
};

template <typename T>
constexpr Row<T> row(const char* name, T CheckOptions::*value, Kind kind, const char* help,
                     const arguments::OptionSyntax& syntax = {}) {
  return {name, value, kind, help, syntax};
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
    row("--budget", &CheckOptions::budget, Kind::plain,
        "Limit the work of each pair in each frame, in units of about one test of two "
        "triangles, and report what is not decided",
        {.type = "WORK", .least = 1}),
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

constexpr const char* kOneOfTwo = "give one of the two";
constexpr const char* kAlone = "check that scene alone";
constexpr const char* kToMerge = "give it to pelt merge";
constexpr const char* kToShards = "give it to each pelt check --shard";
constexpr const char* kShardsOfList = "shards of a list of scenes";

/// Of several conflicts, the first one is reported.
constexpr Conflict kConflicts[] = {
    {"--clearance", "--contacts", kOneOfTwo},
    {"--clearance", "--inside", kOneOfTwo},
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
    {"--html", "--scenes", kAlone},
    {"--glb", "--scenes", kAlone},
    {"--glb-frame", "--scenes", kAlone},
    {"--jsonl", "--shard", kToMerge},
    {"--glb", "--shard", kToMerge},
    {"--glb-frame", "--shard", kToMerge},
    {"--html", "--shard", kToMerge},
    {"--baseline", "--shard", kToMerge},
    {"--fail-on", "--shard", kToMerge},
    {"--allow-empty", "--shard", kToMerge},
    {"--baseline", kShardsOfList, kToShards},
    {"--fail-on", kShardsOfList, kToShards},
    {"--allow-empty", kShardsOfList, kToShards},
    {"--html", kShardsOfList, kAlone},
    {"--glb", kShardsOfList, kAlone},
    {"--glb-frame", kShardsOfList, kAlone},
};

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

bool is_given(std::string_view name, const CheckOptions& options) {
  static const CheckOptions kDefaults;
  bool given = false;
  each_row([&](const auto& row) {
    given = given || (row.name == name && options.*row.value != kDefaults.*row.value);
  });
  return given;
}

/// Calls `visit` with the key and the value of each option that the answers of frames depend on.
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
  visit_rows(is_question);
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

void clear_verdict(CheckOptions& options) {
  const CheckOptions defaults;
  each_row([&](const auto& row) {
    if (row.kind == Kind::verdict) options.*row.value = defaults.*row.value;
  });
}

Error Conflict::error() const {
  return text::bad_argument(option, std::string("cannot be combined with ") + with, remedy);
}

const Conflict* conflict_of(std::string_view option, const CheckOptions& given) {
  for (const Conflict& conflict : kConflicts)
    if (conflict.option == option && is_given(conflict.with, given)) return &conflict;
  return nullptr;
}

const Conflict* conflict_with(std::string_view with, const CheckOptions& given) {
  for (const Conflict& conflict : kConflicts)
    if (conflict.with == with && is_given(conflict.option, given)) return &conflict;
  return nullptr;
}

ordered_json options_json(const CheckOptions& options) {
  ordered_json object;
  visit_answer_options(
      options, [&](const std::string& key, const auto& value) { object[key] = to_json(value); });
  return object;
}

bool read_options(const nlohmann::json& object, CheckOptions& options) {
  bool is_good = object.is_object();
  visit_answer_options(options, [&](const std::string& key, auto& value) {
    const auto found = is_good ? object.find(key) : object.end();
    is_good = is_good && found != object.end() && read(*found, value);
  });
  return is_good && options.scene.inputs.empty() != options.scenes.empty();
}

void add_plain_questions(const CheckOptions& options, ordered_json& header) {
  each_row([&](const auto& row) {
    if (row.kind == Kind::plain && is_given(row.name, options))
      header[key_of(row.name)] = to_json(options.*row.value);
  });
}

std::vector<std::string> keys_of_plain_questions() {
  std::vector<std::string> keys;
  each_row([&](const auto& row) {
    if (row.kind == Kind::plain) keys.push_back(key_of(row.name));
  });
  return keys;
}

}  // namespace pelt::tools::check
