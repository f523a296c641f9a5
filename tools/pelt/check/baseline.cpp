#include "tools/pelt/check/baseline.hpp"

#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"
#include "asset/parsed_json.hpp"
#include "text/message.hpp"
#include "tools/pelt/check/json_fields.hpp"
#include "tools/pelt/check/options.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <algorithm>

namespace pelt::tools::check {
namespace {

using asset::FirstError;
using asset::JsonObject;

/// "--by part", or "without --clearance".
std::string option_words(const std::string& option, const nlohmann::json& value) {
  if (value.is_null()) return "without " + option;
  return option + " " + (value.is_string() ? value.get<std::string>() : value.dump());
}

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

std::string_view last_line(std::string_view text) {
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  const std::size_t end = text.rfind('\n');
  return end == std::string_view::npos ? text : text.substr(end + 1);
}

BodyName read_body(const JsonObject& object) {
  constexpr std::size_t kAnyCopy = std::size_t{1} << 32;
  return {object.text("model"), object.index("copy", kAnyCopy), object.text("part")};
}

TouchName read_place(const JsonObject& object) { return {read_body(object), object.text("joint")}; }

CheckBaseline::TouchNames ordered(TouchName a, TouchName b, std::optional<std::string> clip) {
  if (b < a) std::swap(a, b);
  return {std::move(a), std::move(b), std::move(clip)};
}

std::optional<std::string> read_clip(const JsonObject& object) {
  if (!object.has("clip")) return std::nullopt;
  return object.text("clip");
}

Error incomparable(const std::string& difference, const std::string& remedy) {
  return {ErrorCode::invalid_argument, difference + ": " + remedy};
}

/// Returns an error for options that prevent a comparison.
Result<void> compare_questions(const nlohmann::json& theirs, const nlohmann::json& ours) {
  for (const char* key : {"by", "clearance"}) {
    const nlohmann::json then = value_of(theirs, key);
    const std::string option = std::string("--") + key;
    if (then != ours[key])
      return incomparable("was written " + option_words(option, then) + ", but this check is " +
                              option_words(option, ours[key]),
                          "use the same options, or write a new baseline");
  }
  const bool asked_self = !value_of(theirs, "self").is_null();
  if (asked_self == ours["self"].is_null())
    return incomparable(asked_self ? "was written with --self, which this check leaves out"
                                   : "was written without --self, but this check is with it",
                        "use the same options, or write a new baseline");
  const bool played_all = !value_of(theirs, "clips").is_null();
  if (played_all != !value_of(ours, "clips").is_null())
    return incomparable(played_all ? "was written with all clips of a model ('*')"
                                   : "was written without the clip '*', which this check plays",
                        "play the same clips, or write a new baseline");
  if (!value_of(theirs, "max_contacts").is_null())
    return incomparable("was written with --first or --max-contacts and lacks contacts",
                        "write a new baseline without them");
  if (ours["inside"] == true && value_of(theirs, "inside") != true)
    return incomparable("was written without --inside",
                        "write a new baseline with --inside, or leave out --inside");
  if (!ours["between"].is_null() && value_of(theirs, "between").is_null())
    return incomparable("was written without --between",
                        "write a new baseline with --between, or leave out --between");
  return {};
}

/// Notes differences that do not prevent a comparison. Earlier versions wrote fewer keys; options
/// that the header states only if given are compared all the same.
void note_differences(const nlohmann::json& theirs, const nlohmann::json& ours,
                      std::vector<std::string>& notes) {
  const auto compare = [&](const std::string& key, bool may_lack) {
    const nlohmann::json& then = value_of(theirs, key);
    const nlohmann::json& now = value_of(ours, key);
    if ((then.is_null() && may_lack) || then == now) return;
    notes.push_back(key + " was " + then.dump() + " in the baseline and is " + now.dump() + " now");
  };
  for (const char* key : {"clips", "frames", "between", "self", "fps", "ignore", "exclude",
                          "no_unskinned", "renormalise", "skinning"})
    compare(key, true);
  for (const std::string& key : stated_keys()) compare(key, false);
}

/// Returns the sorted names of the models of all instances.
std::vector<std::string> models_of(const scenes::Scene& scene) {
  std::vector<std::string> models;
  for (const scenes::Instance& instance : scene.instances)
    models.push_back(scene::as_json_holds(scene.characters[instance.character].name));
  std::sort(models.begin(), models.end());
  return models;
}

/// The same for a header, which has one entry per collider.
std::vector<std::string> models_of(const JsonObject& header) {
  constexpr std::size_t kAnyInstance = std::size_t{1} << 32;
  std::map<std::uint32_t, std::string> by_instance;
  for (const JsonObject& collider : header.objects("instances")) {
    const char* const key = collider.has("instance") ? "instance" : "index";
    by_instance[collider.index(key, kAnyInstance)] = collider.text("model");
  }
  std::vector<std::string> models;
  models.reserve(by_instance.size());
  for (const auto& [instance, model] : by_instance) models.push_back(model);
  std::sort(models.begin(), models.end());
  return models;
}

/// Lists each name once: "knight", "thief".
std::string listed(std::vector<std::string> names) {
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + text::quoted(name);
  return text.empty() ? "nothing" : text;
}

bool have_one_in_common(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& name) {
    return std::binary_search(b.begin(), b.end(), name);
  });
}

/// Checks that the scenes share a model.
Result<void> compare_models(const std::vector<std::string>& theirs,
                            const std::vector<std::string>& ours, std::vector<std::string>& notes) {
  if (theirs == ours) return {};
  if (!have_one_in_common(theirs, ours))
    return incomparable(
        "belongs to another scene, with " + listed(theirs) + " instead of " + listed(ours),
        "give the baseline of this scene; if models were renamed, write a new baseline, or use "
        "the earlier names: file names without extension, or keys under \"models\" of a scene");
  notes.push_back("instances were " + std::to_string(theirs.size()) + " of " + listed(theirs) +
                  " in the baseline and are " + std::to_string(ours.size()) + " of " +
                  listed(ours) + " now");
  return {};
}

constexpr const char* kAnswerOfCheck = ": give a file written by pelt check --jsonl";

Error unusable_baseline(const std::string& path, const Error& error) {
  const bool is_answer = error.code != ErrorCode::malformed_file;
  const std::string problem =
      is_answer ? error.message
                : "is not a complete answer of pelt check (" + error.message + ")" + kAnswerOfCheck;
  return {error.code, "--baseline: " + path + ": " + problem};
}

void require_check(const JsonObject& header) {
  if (header.text("format") != "pelt-check") header.refuse("format", "must be pelt-check");
  if (header.count("version") != 1) header.refuse("version", "must be 1");
  if (!header.is_object("options")) header.refuse("options", "must be an object");
}

}  // namespace

/// `first` and `last` are the first and the last line.
Result<CheckBaseline> CheckBaseline::compare(const nlohmann::json& first,
                                             const nlohmann::json& last,
                                             const nlohmann::ordered_json& question,
                                             const scenes::Scene& scene) {
  FirstError errors;
  const JsonObject header(first, "", errors), totals(last, "", errors);
  require_check(header);
  if (errors.get()) return *errors.get();
  const nlohmann::json ours = scene::as_json_holds(question);
  if (const auto same = compare_questions(first["options"], ours); !same) return same.error();
  CheckBaseline baseline;
  note_differences(first["options"], ours, baseline.notes_);
  baseline.touches_ = read_touches(totals, "touches");
  if (!ours["between"].is_null())
    baseline.touches_between_ = read_touches(totals, "touches_between");
  if (ours["inside"] == true) baseline.take_held(totals);
  const std::vector<std::string> models = models_of(header);
  if (errors.get()) return *errors.get();
  const auto compared = compare_models(models, models_of(scene), baseline.notes_);
  if (!compared) return compared.error();
  return baseline;
}

CheckBaseline::Touches CheckBaseline::read_touches(const JsonObject& totals, const char* key) {
  Touches touches;
  if (!totals.has(key)) totals.refuse(key, "is missing from the last line");
  for (const JsonObject& touch : totals.objects(key)) {
    const TouchNames names =
        ordered(read_place(touch.object("a")), read_place(touch.object("b")), read_clip(touch));
    touches[names] = std::max(touches[names], touch.object("worst").count("contacts"));
  }
  return touches;
}

void CheckBaseline::take_held(const JsonObject& totals) {
  if (!totals.has("held")) totals.refuse("held", "is missing from the last line");
  for (const JsonObject& held : totals.objects("held"))
    held_.insert(
        {read_body(held.object("inner")), read_body(held.object("outer")), read_clip(held)});
}

Result<CheckBaseline> CheckBaseline::parse(const std::string& path, std::string_view text,
                                           const nlohmann::ordered_json& question,
                                           const scenes::Scene& scene) {
  const Result<asset::ParsedJson> first = asset::parse_json(first_line(text));
  if (!first) return unusable_baseline(path, first.error());
  const Result<asset::ParsedJson> last = asset::parse_json(last_line(text));
  if (!last) return unusable_baseline(path, last.error());
  Result<CheckBaseline> baseline = compare(**first, **last, question, scene);
  if (!baseline) return unusable_baseline(path, baseline.error());
  return baseline;
}

Result<CheckBaseline> CheckBaseline::read(const std::string& path,
                                          const nlohmann::ordered_json& question,
                                          const scenes::Scene& scene) {
  const auto bytes = asset::read_file(path);
  if (!bytes)
    return text::prefixed("--baseline",
                          {bytes.error().code, bytes.error().message + kAnswerOfCheck});
  const auto* text = reinterpret_cast<const char*>(bytes->data());
  return parse(path, {text, bytes->size()}, question, scene);
}

std::uint64_t worst_of(const CheckBaseline::Touches& touches,
                       const CheckBaseline::TouchNames& names) {
  const auto found = touches.find(names);
  return found == touches.end() ? 0 : found->second;
}

CheckBaseline::TouchNames names_of(const scene::StagedScene& staged, const Touch& touch) {
  return ordered(touch_name(staged, touch.a), touch_name(staged, touch.b),
                 clip_name(staged.scene, touch.take));
}

CheckBaseline::HeldNames names_of(const scene::StagedScene& staged, const Held& held) {
  return {body_name(staged, staged.colliders[held.inner]),
          body_name(staged, staged.colliders[held.outer]), clip_name(staged.scene, held.take)};
}

}  // namespace pelt::tools::check
