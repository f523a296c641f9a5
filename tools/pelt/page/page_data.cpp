#include "tools/pelt/page/page_data.hpp"

#include <pelt/version.hpp>

#include "asset/file_bytes.hpp"
#include "base/hash.hpp"
#include "scenes/scene_text.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/page/geometry_copy.hpp"

#include <nlohmann/json.hpp>

#include <ctime>
#include <sstream>

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The page is text, and so are the paths in it.
std::string name_in_page(const fs::path& path) {
  const std::string name = path.stem().string();
  return (text::as_utf8(name) == name ? name : "model") + ".glb";
}

/// Another process may have changed the file since it was read.
Result<void> check_unchanged(const scenes::Character& character, std::span<const std::byte> bytes) {
  detail::Fnv1a64 hash;
  hash.add_bytes(bytes);
  if (hash.value() == character.hash) return {};
  return Error{ErrorCode::unreadable_file,
               character.source + ": was changed after it was read: try again"};
}

Result<void> add_character(const scenes::Character& character, const fs::path& path,
                           const std::string& folder, CharacterFiles& files) {
  const auto original = asset::read_file(path);
  if (!original) return original.error();
  if (const auto unchanged = check_unchanged(character, *original); !unchanged) return unchanged;
  const fs::path beside = path.has_parent_path() ? path.parent_path() : ".";
  auto copy = copy_geometry(*original, beside, character.buffer_views);
  if (!copy) return text::prefixed(character.source, copy.error());
  files.paths.back() = folder + name_in_page(path);
  files.original_sizes.back() = original->size();
  files.bytes[files.paths.back()] = *std::move(copy);
  return {};
}

/// "2026-11-22T14:05:09Z"
std::string time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  gmtime_r(&now, &utc);
  char text[sizeof "2026-11-22T14:05:09Z"];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string as_text(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Otherwise, the scene consists of models on the command line.
bool has_file(const scenes::Scene& scene) { return fs::path(scene.name).extension() == ".json"; }

std::string scene_path(const scenes::Scene& scene) {
  return has_file(scene) ? scene.name : "scene.json";
}

/// Title of the scene: the name of its file, or the names of its models.
std::string scene_title(const scenes::Scene& scene) {
  if (has_file(scene)) return scene.name;
  std::string title;
  for (const scenes::Character& character : scene.characters)
    title += (title.empty() ? "" : ", ") + fs::path(character.source).filename().string();
  return title;
}

ordered_json files_json(const CharacterFiles& files, const std::string& scene,
                        const std::string& text) {
  ordered_json json = {{scene, text::base64(text)}};
  for (const auto& [path, bytes] : files.bytes) json[path] = text::base64(as_text(bytes));
  return json;
}

/// Lists the files of the characters under the given paths.
ordered_json inputs_json(const scenes::Scene& scene, const CharacterFiles& files) {
  ordered_json inputs = ordered_json::array();
  for (std::size_t c = 0; c < scene.characters.size(); ++c) {
    const scenes::Character& character = scene.characters[c];
    ordered_json& input = inputs.emplace_back();
    input = {{"path", character.source}, {"file", nullptr}, {"bytes", nullptr}};
    input["hash"] = text::hex16(character.hash);
    if (files.paths[c].empty()) continue;
    input["file"] = files.paths[c];
    input["bytes"] = files.original_sizes[c];
  }
  return inputs;
}

ordered_json reading_json(const arguments::ModelArguments& models) {
  ordered_json json = {{"renormalise", models.renormalise},
                       {"noUnskinned", models.no_unskinned},
                       {"exclude", models.exclude},
                       {"samples", models.samples}};
  if (!models.skinning.empty()) json["skinning"] = models.skinning;  // else the scene says it
  return json;
}

/// The clips that are played one after the other, with their frames; null if there are none.
ordered_json clips_json(const scenes::Scene& scene) {
  ordered_json clips;
  for (const scenes::Take& take : scene.takes)
    clips.push_back(
        {{"clip", take.clip}, {"first_frame", take.first_frame}, {"frames", take.frame_count}});
  return clips;
}

/// Null without --between.
ordered_json steps_json(const std::optional<std::vector<PageStep>>& steps) {
  if (!steps) return nullptr;
  ordered_json json = ordered_json::array();
  for (const PageStep& step : *steps)
    json.push_back({{"step", step.from},
                    {"to", step.to},
                    {"only_between", step.contacts},
                    {"first", step.first_seconds},
                    {"share", step.first_share},
                    {"a", step.a},
                    {"b", step.b},
                    {"triangles", {step.triangles.triangle_a, step.triangles.triangle_b}},
                    {"of_self", step.is_of_self}});
  return json;
}

ordered_json answer_json(const PageAnswer& answer) {
  std::istringstream lines(answer.lines);
  ordered_json first, last;
  lines >> first >> last;
  ordered_json json = {{"options", first["options"]}, {"counts", answer.counts}};
  json["steps"] = steps_json(answer.steps);
  json.update(last);
  return json;
}

}  // namespace

Result<CharacterFiles> read_character_files(const scenes::Scene& scene) {
  CharacterFiles files;
  for (std::size_t c = 0; c < scene.characters.size(); ++c) {
    const scenes::Character& character = scene.characters[c];
    files.paths.emplace_back();
    files.original_sizes.emplace_back();
    const auto* path = std::get_if<fs::path>(&character.origin);
    if (!path) continue;
    const auto added = add_character(character, *path, std::to_string(c) + "/", files);
    if (!added) return added.error();
  }
  return files;
}

Result<std::string> page_data(const scenes::Scene& scene, const arguments::ModelArguments& models,
                              const PageData& data) {
  const Result<CharacterFiles> files = read_character_files(scene);
  if (!files) return files.error();
  const std::string path = scene_path(scene);
  ordered_json json = {{"format", "pelt-report"},
                       {"version", 1},
                       {"pelt", PELT_VERSION},
                       {"made", time_now()},
                       {"command", data.command},
                       {"title", scene_title(scene)},
                       {"scene", path},
                       {"files", files_json(*files, path, scenes::scene_text(scene, files->paths))},
                       {"inputs", inputs_json(scene, *files)},
                       {"reading", reading_json(models)},
                       {"clips", clips_json(scene)},
                       {"answer", nullptr}};
  if (data.answer) json["answer"] = answer_json(*data.answer);
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace pelt::tools::page
