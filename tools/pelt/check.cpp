/// `pelt check`: which triangles collide, frame by frame.

#include "asset/message.hpp"
#include "scenes/ignored_pairs.hpp"
#include "scenes/nearest_name.hpp"
#include "tools/pelt/check_scene.hpp"
#include "tools/pelt/commands.hpp"
#include "tools/pelt/json_lines.hpp"
#include "tools/pelt/query_arguments.hpp"
#include "tools/pelt/simd_argument.hpp"
#include "tools/pelt/text.hpp"
#include "tools/pelt/verb.hpp"
#include "tools/pelt/viewer_page.hpp"

namespace pelt::tools {
namespace {

struct Arguments {
  SceneArguments scene;
  std::string frames, by = "instance", method = "on_demand";
  bool first = false, pairs = false, contacts = false, inside = false;
  std::optional<double> clearance;
  std::optional<std::uint32_t> max_contacts, glb_frame;
  std::vector<std::string> ignore;
  std::string baseline, fail_on;
  std::string jsonl, glb, html, simd, words;
};

constexpr const char* kFooter = R"(
Examples:
  pelt check scene.json
  pelt check knight.glb barbarian.glb --clip Walk --clip Attack --at 0,0,-0.5 --at 0,0,0.5 --turn 0 --turn 180
  pelt check knight.glb --clip Walk --by part
  pelt check scene.json --frames 20:40 --jsonl contacts.jsonl --pairs
  pelt check scene.json --contacts --jsonl contacts.jsonl
  pelt check scene.json --clearance 0.02
  pelt check scene.json --inside
  pelt check scene.json --first --jsonl - > contacts.jsonl
  pelt check scene.json --glb worst.glb
  pelt check scene.json --html report.html
  pelt check scene.json --method brute --frames 24:25
  pelt check scene.json --ignore limb,joint*
  pelt check scene.json --baseline contacts.jsonl

Exact: triangles are closed, so touching counts, on the very float32 positions that `pelt pose`
writes. All methods give the same contacts and the same hash; they differ in their work.
With --by part, a and b number the colliders of the header's "instances", one for each part.
Names of --ignore are those of parts and joints, of one model as in knight/hand_r; * stands for any
characters. A baseline is an earlier --jsonl: then only what is new or has grown fails.
Exit codes: 0 no contact, 1 contact (or what --fail-on says; with --inside also one that holds
another), 2 bad input or arguments, 3 internal error.)";

Result<bench::MethodKind> choose_method(const std::string& name) {
  if (const auto method = bench::find_method(name)) return *method;
  return Error{ErrorCode::invalid_argument, "--method: there is no " + asset::quoted(name) +
                                                scenes::suggestion(name, bench::method_names())};
}

Result<std::optional<std::uint32_t>> choose_limit(const Arguments& arguments) {
  if (arguments.first) return std::optional<std::uint32_t>(1);
  if (arguments.max_contacts == 0u) {
    return bad_argument("--max-contacts", "a limit of 0 finds nothing", "give 1 or more");
  }
  return arguments.max_contacts;
}

bool contains(const FrameRange& range, std::uint32_t frame) {
  return frame >= range.begin && frame < range.end && (frame - range.begin) % range.stride == 0;
}

Result<std::optional<std::uint32_t>> choose_glb_frame(const Arguments& arguments,
                                                      const FrameRange& frames) {
  if (!arguments.glb_frame) return arguments.glb_frame;
  if (arguments.glb.empty()) {
    return bad_argument("--glb-frame", "there is no --glb", "name the file with --glb FILE");
  }
  if (contains(frames, *arguments.glb_frame)) return arguments.glb_frame;
  return bad_argument("--glb-frame", std::to_string(*arguments.glb_frame) + " is not checked",
                      "choose one of the frames that are");
}

Result<std::optional<double>> choose_clearance(const Arguments& arguments,
                                               bench::MethodKind method) {
  if (!arguments.clearance) return arguments.clearance;
  if (!(*arguments.clearance >= 0 && *arguments.clearance <= 1e12))
    return bad_argument("--clearance", "is out of range", "give a number from 0 to 1e12");
  if (method != bench::MethodKind::on_demand)
    return bad_argument("--clearance", "only on_demand answers that", "leave out --method");
  if (arguments.contacts)
    return bad_argument("--clearance", "what does not touch has no --contacts",
                        "give one of the two");
  if (arguments.inside)
    return bad_argument("--clearance", "what is --inside is told of bodies that touch or not",
                        "give one of the two");
  return arguments.clearance;
}

/// "A,B": the last comma parts the names.
Result<scenes::NamePair> parse_name_pair(const std::string& text) {
  const std::size_t comma = text.rfind(',');
  if (comma != std::string::npos && comma > 0 && comma + 1 < text.size())
    return scenes::NamePair{text.substr(0, comma), text.substr(comma + 1)};
  return bad_argument("--ignore", asset::quoted(text) + " is not a pair of names",
                      "give two parts or joints as in --ignore cape,spine");
}

/// With --exclude or --no-unskinned a scene's rules may name what is left out.
bool is_read_whole(const ModelArguments& models) {
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

Result<std::vector<scenes::NamePair>> choose_ignored(const Arguments& arguments,
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
  return bad_argument(arguments.first ? "--first" : "--max-contacts",
                      "the contacts found first may be those to ignore", "leave it out");
}

Result<std::optional<KnownTouches>> choose_baseline(const Arguments& arguments) {
  if (arguments.baseline.empty()) return std::optional<KnownTouches>();
  if (arguments.first || arguments.max_contacts)
    return bad_argument("--baseline", "needs all contacts", "leave out --first and --max-contacts");
  Result<KnownTouches> known =
      KnownTouches::read(arguments.baseline, {arguments.by, arguments.clearance});
  if (!known) return known.error();
  return std::optional<KnownTouches>(std::move(*known));
}

Result<FailOn> choose_fail_on(const Arguments& arguments) {
  if (arguments.fail_on.empty())
    return arguments.baseline.empty() ? FailOn::contact : FailOn::grown;
  const auto fail_on = find_fail_on(arguments.fail_on);
  if (!fail_on)
    return bad_argument("--fail-on", "there is no " + asset::quoted(arguments.fail_on),
                        "give contact, grown, new or never");
  const bool needs_baseline = *fail_on == FailOn::grown || *fail_on == FailOn::newly;
  if (needs_baseline && arguments.baseline.empty())
    return bad_argument("--fail-on", arguments.fail_on + " needs something to compare with",
                        "name an earlier answer with --baseline FILE");
  return *fail_on;
}

/// The page counts contacts of instances itself: it can show no answer to another question.
Result<void> check_for_page(const Arguments& arguments, const scenes::Scene& scene) {
  if (arguments.html.empty()) return {};
  const auto refused = [](const char* option) {
    return bad_argument("--html", std::string("the page does not know ") + option, "leave it out");
  };
  if (arguments.by != "instance") return refused("--by part");
  if (arguments.clearance) return refused("--clearance");
  if (arguments.max_contacts) return refused("--max-contacts");
  if (!arguments.ignore.empty()) return refused("--ignore");
  if (!scene.ignore.empty())
    return bad_argument("--html", "the page does not know what " + scene.name + " ignores",
                        "leave out its \"ignore\"");
  // What is missing should be said before long work.
  if (const auto viewer = read_viewer(); !viewer) return viewer.error();
  return check_writable(arguments.html);
}

Result<CheckSettings> choose_settings(const Arguments& arguments, scenes::Scene& scene) {
  CheckSettings settings;
  if (const auto checked = check_for_page(arguments, scene); !checked) return checked.error();
  const auto method = choose_method(arguments.method);
  if (!method) return method.error();
  settings.method = *method;
  const auto clearance = choose_clearance(arguments, settings.method);
  if (!clearance) return clearance.error();
  settings.clearance = *clearance;
  settings.describes_contacts = arguments.contacts;
  settings.asks_inside = arguments.inside;
  const auto granularity = choose_granularity(arguments.by);
  if (!granularity) return granularity.error();
  settings.granularity = *granularity;
  const auto limit = choose_limit(arguments);
  if (!limit) return limit.error();
  settings.max_contacts = *limit;
  const auto frames = choose_frames(arguments.frames, arguments.scene, scene);
  if (!frames) return frames.error();
  settings.frames = *frames;
  const auto ignore = choose_ignored(arguments, scene);
  if (!ignore) return ignore.error();
  settings.ignore = *ignore;
  auto known = choose_baseline(arguments);
  if (!known) return known.error();
  settings.known = std::move(*known);
  const auto fail_on = choose_fail_on(arguments);
  if (!fail_on) return fail_on.error();
  settings.fail_on = *fail_on;
  const auto glb_frame = choose_glb_frame(arguments, settings.frames);
  if (!glb_frame) return glb_frame.error();
  settings.frame_to_keep = *glb_frame;
  return settings;
}

Result<ExitCode> check(const Arguments& arguments) {
  if (const auto chosen = choose_simd(arguments.simd); !chosen) return chosen.error();
  Result<scenes::Scene> scene = open_scene(arguments.scene);
  if (!scene) return scene.error();
  const Result<CheckSettings> settings = choose_settings(arguments, *scene);
  if (!settings) return settings.error();
  CheckOutputs outputs;
  outputs.jsonl = arguments.jsonl;
  outputs.glb = arguments.glb;
  outputs.html = arguments.html;
  outputs.words = arguments.words;
  outputs.lists = arguments.pairs ? TriangleLists::written : TriangleLists::left_out;
  const Result<CheckReport> report = check_scene(*scene, *settings, arguments.scene.models, outputs,
                                                 words_beside(arguments.jsonl));
  if (!report) return report.error();
  const bool is_held = report->inside && !report->inside->frames_held.empty();
  const bool is_failed =
      report->verdict.is_failed || (is_held && settings->fail_on != FailOn::never);
  return is_failed ? ExitCode::contact : ExitCode::success;
}

std::string listed(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

void add_options(Verb& verb, Arguments& arguments) {
  add_scene_options(verb, arguments.scene);
  verb.option("--frames", arguments.frames,
              "Frames A to B - 1, each S-th of them with A:B:S (default: all of the scene, or of "
              "the longest clip)",
              {.type = "A:B"});
  verb.option("--by", arguments.by,
              "What collides: every instance with every other, or every part with every other, "
              "also of the same instance",
              {.type = "instance|part"});
  verb.option("--method", arguments.method, "One of " + listed(bench::method_names()),
              {.type = "NAME"});
  add_simd_option(verb, arguments.simd);
  verb.flag("--first", arguments.first, "Stop at the first contact of each pair in each frame");
  verb.option("--max-contacts", arguments.max_contacts,
              "Stop after so many contacts of each pair in each frame",
              {.type = "N", .excludes = "--first"});
  verb.option("--ignore", arguments.ignore,
              "Contacts of two parts or joints that do not count; may be given several times",
              {.type = "A,B"});
  verb.option("--baseline", arguments.baseline,
              "Compare with the --jsonl of an earlier check: fail only on parts and joints that "
              "touch newly, or with more contacts in their worst frame",
              {.type = "FILE"});
  verb.option("--fail-on", arguments.fail_on,
              "What makes the exit code 1 (default: contact, with a baseline grown)",
              {.type = "contact|grown|new|never"});
  verb.option("--jsonl", arguments.jsonl,
              "Write the answer, a JSON object a line; -: to standard output, the summary then to "
              "standard error",
              {.type = "FILE"});
  verb.flag("--pairs", arguments.pairs, "Write the triangle pairs too, not only their number");
  verb.flag("--contacts", arguments.contacts,
            "Tell where and how the triangles cut each other: segments, curves, regions, normals, "
            "depths, joints");
  verb.flag("--inside", arguments.inside,
            "Of closed surfaces, tell too which holds another whole, and how deep the deepest "
            "vertex is where they touch");
  verb.option(
      "--clearance", arguments.clearance,
      "Find all pairs of triangles that are at most so far apart, not only those that touch",
      {.type = "DISTANCE"});
  verb.option(
      "--html", arguments.html,
      "Write the report: a page that plays the scene and finds its contacts, all in one file",
      {.type = "FILE"});
  verb.option("--glb", arguments.glb,
              "Write the posed characters of the worst frame, colliding triangles coloured",
              {.type = "FILE"});
  verb.option("--glb-frame", arguments.glb_frame, "The frame for --glb", {.type = "N"});
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  Verb verb(app, "check", "Find every colliding triangle pair of every frame", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  add_options(verb, *arguments);
  verb.tells(arguments->words);
  verb.runs([arguments] { return check(*arguments); }, chosen);
}

}  // namespace pelt::tools
