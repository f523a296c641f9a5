#include "tools/pelt/list/entry.hpp"

#include "asset/file_bytes.hpp"
#include "asset/parsed_json.hpp"
#include "text/format.hpp"
#include "text/json_text.hpp"
#include "text/message.hpp"
#include "tools/pelt/check/json_fields.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <unordered_set>

namespace pelt::tools::list {
namespace {

using nlohmann::ordered_json;

/// The hash as text.
bool read_hash(const nlohmann::json& value, std::optional<std::uint64_t>& hash) {
  hash.reset();
  if (value.is_null()) return true;
  return value.is_string() && text::parse_hex16(value.get<std::string>(), hash.emplace());
}

/// The contacts of the worst frame, and its number.
bool read_worst(const nlohmann::json& value, SceneEntry& entry) {
  return value.is_null() || (check::read(check::value_of(value, "contacts"), entry.worst) &&
                             check::read(check::value_of(value, "frame"), entry.worst_frame));
}

/// Calls `visit` with the key and the value of each number of a scene that was checked.
template <typename Entry, typename Visit>
void visit_numbers(Entry& entry, const Visit& visit) {
  visit("frames", entry.frames);
  visit("frames_in_contact", entry.frames_in_contact);
  visit("contacts", entry.contacts);
}

std::string entry_line(const SceneEntry& entry) {
  ordered_json line = {
      {"scene", entry.scene}, {"error", check::to_json(entry.error)}, {"lines", entry.lines}};
  if (entry.error) return text::json_text(line) + '\n';
  visit_numbers(entry, [&](const char* key, std::uint64_t value) { line[key] = value; });
  line["worst"] = nullptr;
  if (entry.worst > 0) line["worst"] = {{"frame", entry.worst_frame}, {"contacts", entry.worst}};
  line["hash"] = nullptr;
  if (entry.hash) line["hash"] = text::hex16(*entry.hash);
  line["failed"] = entry.is_failed;
  return text::json_text(line) + '\n';
}

/// Removes the carriage return of a line that was written on Windows.
std::string_view without_return(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Error at_line(const std::string& path, std::size_t line, const std::string& problem,
              const std::string& remedy) {
  return text::bad_argument("--scenes: " + path + ": line " + std::to_string(line), problem,
                            remedy);
}

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

SceneAnswer answer_of(const std::string& scene, const check::CheckReport& report,
                      const std::string& lines) {
  SceneAnswer answer;
  SceneEntry& entry = answer.entry;
  entry.scene = scene;
  entry.lines = static_cast<std::uint64_t>(std::count(lines.begin(), lines.end(), '\n'));
  entry.frames = report.totals.frames;
  entry.frames_in_contact = report.totals.frames_in_contact;
  entry.contacts = report.totals.contacts;
  entry.worst = report.worst_contacts;
  entry.worst_frame = report.worst_frame;
  entry.is_failed = report.verdict.is_failed;
  entry.hash = report.totals.hash;
  answer.text = entry_line(entry) + lines;
  return answer;
}

SceneAnswer unchecked(const std::string& scene, const Error& error) {
  SceneAnswer answer;
  answer.entry.scene = scene;
  answer.entry.error = error.message;
  answer.text = entry_line(answer.entry);
  return answer;
}

bool read_line(std::istream& in, std::string& line) { return std::getline(in, line) && !in.eof(); }

std::optional<SceneEntry> read_entry(const std::string& text) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(text);
  if (!parsed) return std::nullopt;
  SceneEntry entry;
  const auto value = [&](const char* key) -> const nlohmann::json& {
    return check::value_of(**parsed, key);
  };
  bool is_good =
      check::read(value("scene"), entry.scene) && check::read(value("error"), entry.error);
  if (!is_good || entry.error) return is_good ? std::optional(entry) : std::nullopt;
  visit_numbers(entry, [&](const char* key, std::uint64_t& number) {
    is_good = is_good && check::read(value(key), number);
  });
  is_good = is_good && check::read(value("lines"), entry.lines) &&
            read_worst(value("worst"), entry) && read_hash(value("hash"), entry.hash) &&
            check::read(value("failed"), entry.is_failed);
  return is_good ? std::optional(entry) : std::nullopt;
}

std::optional<std::vector<std::string>> read_lines_of(const SceneEntry& entry, std::istream& in) {
  std::vector<std::string> lines;
  while (lines.size() < entry.lines)
    if (!read_line(in, lines.emplace_back())) return std::nullopt;
  return lines;
}

Result<std::vector<std::string>> read_scene_list(const std::string& path) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return text::prefixed("--scenes", bytes.error());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  std::vector<std::string> scenes;
  std::unordered_map<std::string_view, std::size_t> lines;
  std::size_t number = 0;
  for (std::string_view line : text::split(text, '\n')) {
    ++number;
    line = without_return(line);
    if (line.empty()) continue;
    if (line.find('\0') != line.npos)
      return at_line(path, number, "is not text", "give a text file with a scene on each line");
    const auto [known, is_new] = lines.emplace(line, number);
    if (!is_new)
      return at_line(path, number,
                     text::quoted(line) + " is already in line " + std::to_string(known->second),
                     "remove one of the two");
    scenes.emplace_back(line);
    if (scenes.size() > kMostScenes)
      return at_line(path, number, "is beyond the 10 million scenes of a list", "divide the list");
  }
  if (!scenes.empty()) return scenes;
  return text::bad_argument("--scenes: " + path, "lists no scene", "name one on each line");
}

Result<ListBaseline> ListBaseline::read(const std::string& path) {
  const std::string place = "--baseline: " + path;
  std::ifstream in(path, std::ios::binary);
  if (!in.is_open() || (in.peek(), in.bad()))
    return Error{ErrorCode::unreadable_file, place + ": cannot be read: " + kRemedy};
  std::string line;
  if (!read_line(in, line) || !has_format(line))
    return text::bad_argument(place, "is not an answer for a list of scenes", kRemedy);
  ListBaseline baseline;
  while (read_line(in, line)) {
    if (is_last(line)) return baseline;
    const std::optional<SceneEntry> entry = read_entry(line);
    if (!entry) break;
    const auto lines = read_lines_of(*entry, in);
    if (!lines) break;
    if (lines->empty()) continue;
    baseline.scenes_.push_back(entry->scene);
    baseline.texts_[entry->scene] = lines->front() + '\n' + lines->back() + '\n';
  }
  return text::bad_argument(place, "is incomplete or damaged", kRemedy);
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
