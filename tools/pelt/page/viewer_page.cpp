#include "tools/pelt/page/viewer_page.hpp"

#include <pelt/version.hpp>

#include "asset/file_bytes.hpp"
#include "tools/pelt/page/verdict_html.hpp"

#include <cstdlib>

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPlace = R"(<script type="application/json" id="pelt-data">)";

/// Where the result stands until the script runs.
constexpr std::string_view kVerdict = R"(<p id="pelt-verdict">)";

/// Version mark of the page.
constexpr std::string_view kMaker = R"(<meta name="generator" content="Pelt )" PELT_VERSION "\"";

constexpr const char* kRemedy =
    "build it with scripts/build-viewer, or set PELT_VIEWER to its path";

std::string as_text(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const char* problem_of(std::string_view page) {
  if (page.find(kPlace) == page.npos) return "not the viewer's page";
  if (page.find(kMaker) == page.npos) return "the page of another version, not of " PELT_VERSION;
  return nullptr;
}

/// Escapes JSON so that no string closes the surrounding element.
std::string for_script(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text)
    if (c == '<')
      escaped += "\\u003c";
    else
      escaped += c;
  return escaped;
}

}  // namespace

std::vector<fs::path> viewer_places() {
  // The environment is read once, before there are threads.
  const char* named = std::getenv("PELT_VIEWER");  // NOLINT(concurrency-mt-unsafe)
  if (named != nullptr) return {named};
  std::vector<fs::path> places;
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  if (!error)
    places.push_back(command.parent_path().parent_path() / "share" / "pelt" / "viewer.html");
  places.emplace_back(PELT_VIEWER_BUILT);
  return places;
}

Result<std::string> read_viewer() {
  for (const fs::path& place : viewer_places()) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) continue;
    const auto bytes = asset::read_file(place);
    if (!bytes) return bytes.error();
    std::string page = as_text(*bytes);
    const char* problem = problem_of(page);
    if (problem == nullptr) return page;
    return Error{ErrorCode::malformed_file, place.string() + ": is " + problem + ": " + kRemedy};
  }
  return Error{ErrorCode::unreadable_file,
               std::string("the viewer's page was not built: ") + kRemedy};
}

Result<std::string> page_of_scene(const scenes::Scene& scene,
                                  const arguments::ModelArguments& models, const PageData& data) {
  Result<std::string> page = read_viewer();
  if (!page) return page;
  Result<std::string> json = page_data(scene, models, data);
  if (!json) return json;
  page->insert(page->find(kPlace) + kPlace.size(), for_script(*json));
  const std::size_t verdict = page->find(kVerdict);
  if (verdict != page->npos) page->insert(verdict + kVerdict.size(), verdict_html(data));
  return page;
}

}  // namespace pelt::tools::page
