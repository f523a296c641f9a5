#include "tools/pelt/list/list_baseline.hpp"

#include "asset/message.hpp"
#include "asset/parsed_json.hpp"
#include "tools/pelt/list/scene_entry.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <unordered_set>

namespace pelt::tools::list {
namespace {

constexpr const char* kRemedy = "give a file written by pelt check --scenes --jsonl";

bool has_format(const std::string& line) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(line);
  return parsed && (*parsed)->is_object() &&
         (*parsed)->value("format", nlohmann::json()) == "pelt-check-list" &&
         (*parsed)->value("version", nlohmann::json()) == 1;
}

bool is_last(const std::string& line) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(line);
  return parsed && (*parsed)->is_object() && (*parsed)->contains("totals");
}

}  // namespace

Result<ListBaseline> ListBaseline::read(const std::string& path) {
  const std::string place = "--baseline: " + path;
  std::ifstream in(path, std::ios::binary);
  if (!in.is_open() || (in.peek(), in.bad()))
    return Error{ErrorCode::unreadable_file, place + ": cannot be read: " + kRemedy};
  std::string line;
  if (!read_line(in, line) || !has_format(line))
    return output::bad_argument(place, "is not an answer for a list of scenes", kRemedy);
  ListBaseline baseline;
  while (read_line(in, line)) {
    if (is_last(line)) return baseline;
    const Result<SceneEntry> entry = read_entry(line);
    if (!entry) break;
    const auto lines = read_lines_of(*entry, in);
    if (!lines) break;
    if (lines->empty()) continue;
    baseline.scenes_.push_back(entry->scene);
    baseline.texts_[entry->scene] = lines->front() + '\n' + lines->back() + '\n';
  }
  return output::bad_argument(place, "is incomplete or damaged", kRemedy);
}

std::string ListBaseline::text_of(const std::string& scene) const {
  const auto found = texts_.find(scene::as_json_holds(scene));
  return found == texts_.end() ? "" : found->second;
}

std::vector<std::string> ListBaseline::scenes_missing_in(
    std::span<const std::string> scenes) const {
  std::unordered_set<std::string> there;
  for (const std::string& scene : scenes) there.insert(scene::as_json_holds(scene));
  std::vector<std::string> missing = scenes_;
  std::erase_if(missing, [&](const std::string& scene) { return there.contains(scene); });
  return missing;
}

}  // namespace pelt::tools::list
