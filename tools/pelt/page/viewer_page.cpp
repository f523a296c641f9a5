#include "tools/pelt/page/viewer_page.hpp"

#include <pelt/version.hpp>

#include "asset/file_bytes.hpp"
#include "text/format.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <sstream>

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text)
    if (c == '<')
      html += "&lt;";
    else if (c == '&')
      html += "&amp;";
    else
      html += c;
  return html;
}

std::string number(const ordered_json& value) {
  return text::with_commas(value.get<std::uint64_t>());
}

const char* headline(const ordered_json& verdict) {
  if (verdict["failed"] == true) return "Check failed";
  return verdict["fail_on"] == "never" ? "Report" : "Check passed";
}

/// Says what counts as a contact.
std::string clearance_words(const ordered_json& options) {
  const ordered_json& distance = options["clearance"];
  return distance.is_null() ? "" : " (triangles at most " + distance.dump() + " apart)";
}

std::string limit_words(const ordered_json& options) {
  const ordered_json& limit = options["max_contacts"];
  return limit.is_null() ? "" : ", at most " + number(limit) + " of each pair in each frame";
}

/// Says what was tested against itself.
const char* self_sentence(const ordered_json& options) {
  if (options["self"].is_null()) return "";
  if (options["self"]["only"] == true) return " Only contacts of characters with themselves count.";
  return " Contacts of characters with themselves count, too.";
}

/// Says what touches between frames only, with --between.
std::string between_sentence(const ordered_json& totals) {
  if (!totals.contains("between")) return "";
  const ordered_json& between = totals["between"];
  return " Between frames only: " + number(between["contacts"]) + " contacts in " +
         number(between["steps_in_contact"]) + " of " + number(between["steps"]) + " steps.";
}

/// Says in how many frames contacts may be missing, with --budget.
std::string unknown_sentence(const ordered_json& totals) {
  if (!totals.contains("unknown") || totals["unknown"]["frames"] == 0) return "";
  return " The budget did not suffice: more contacts are possible in " +
         number(totals["unknown"]["frames"]) + " frames.";
}

/// Result and command in two sentences, as HTML, for readers whose browser does not run the page's
/// script; empty without an answer.
std::string verdict_html(const PageData& data) {
  if (!data.answer) return "";
  std::istringstream lines(data.answer->lines);
  ordered_json first, last;
  lines >> first >> last;
  const ordered_json& totals = last["totals"];
  return std::string(headline(last["verdict"])) + ": " + number(totals["frames_in_contact"]) +
         " of " + number(totals["frames"]) + " frames in contact, " + number(totals["contacts"]) +
         " contacts" + clearance_words(first["options"]) + limit_words(first["options"]) + "." +
         self_sentence(first["options"]) + between_sentence(totals) + unknown_sentence(totals) +
         " Command: <code>" + escaped(data.command) + "</code>";
}

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
