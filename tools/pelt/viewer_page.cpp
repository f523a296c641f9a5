#include "tools/pelt/viewer_page.hpp"

#include "asset/file_bytes.hpp"
#include "scenes/scene_text.hpp"
#include "tools/pelt/base64.hpp"
#include "tools/pelt/character_files.hpp"
#include "tools/pelt/text.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace pelt::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::string_view kPlace = R"(<script type="application/json" id="pelt-data">)";
constexpr const char* kRemedy =
    "build it with scripts/build-viewer, or name it in the environment as PELT_VIEWER";

/// Where the page may be, the most particular place first.
std::vector<fs::path> places() {
  std::vector<fs::path> places;
  // The environment is read once, before there are threads.
  if (const char* named = std::getenv("PELT_VIEWER"))
    return {named};  // NOLINT(concurrency-mt-unsafe)
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  if (!error)
    places.push_back(command.parent_path().parent_path() / "share" / "pelt" / "viewer.html");
  places.emplace_back(PELT_VIEWER_BUILT);
  return places;
}

std::string as_text(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ordered_json files_json(const CharacterFiles& files, const std::string& scene,
                        const std::string& text) {
  ordered_json json = {{scene, base64(text)}};
  for (const auto& [path, bytes] : files.bytes) json[path] = base64(as_text(bytes));
  return json;
}

ordered_json answer_json(const PageAnswer& answer) {
  ordered_json json = {{"frames", {answer.frames.begin, answer.frames.end, answer.frames.stride}},
                       {"counts", answer.counts},
                       {"hash", nullptr}};
  if (answer.hash) json["hash"] = hex16(*answer.hash);
  return json;
}

/// A scene file's own name, if it has one.
std::string scene_path(const scenes::Scene& scene) {
  return fs::path(scene.name).extension() == ".json" ? scene.name : "scene.json";
}

ordered_json data_json(const scenes::Scene& scene, const ModelArguments& models,
                       const CharacterFiles& files, const PageData& data) {
  const std::string path = scene_path(scene);
  ordered_json json = {{"format", "pelt-report"},
                       {"version", 1},
                       {"command", data.command},
                       {"scene", path},
                       {"files", files_json(files, path, scenes::scene_text(scene, files.paths))},
                       {"reading",
                        {{"renormalise", models.renormalise},
                         {"noUnskinned", models.no_unskinned},
                         {"exclude", models.exclude},
                         {"samples", models.samples}}},
                       {"firstContact", data.first_contact},
                       {"answer", nullptr}};
  if (data.answer) json["answer"] = answer_json(*data.answer);
  return json;
}

/// No string of JSON ends the element that it stands in.
std::string for_script(const ordered_json& json) {
  std::string text = json.dump();
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i))
    text.replace(i, 1, "\\u003c");
  return text;
}

}  // namespace

Result<std::string> read_viewer() {
  for (const fs::path& place : places()) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) continue;
    const auto bytes = asset::read_file(place);
    if (!bytes) return bytes.error();
    std::string page = as_text(*bytes);
    if (page.find(kPlace) != std::string::npos) return page;
    return Error{ErrorCode::malformed_file,
                 place.string() + ": is not the viewer's page: " + kRemedy};
  }
  return Error{ErrorCode::unreadable_file,
               std::string("the viewer's page has not been built: ") + kRemedy};
}

Result<std::string> page_of_scene(const scenes::Scene& scene, const ModelArguments& models,
                                  const PageData& data) {
  Result<std::string> page = read_viewer();
  if (!page) return page;
  const Result<CharacterFiles> files = read_character_files(scene);
  if (!files) return files.error();
  page->insert(page->find(kPlace) + kPlace.size(),
               for_script(data_json(scene, models, *files, data)));
  return page;
}

}  // namespace pelt::tools
