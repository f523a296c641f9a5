#include "tools/pelt/list/scene_entry.hpp"

#include "asset/json_object.hpp"
#include "asset/message.hpp"
#include "asset/parsed_json.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/output/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace pelt::tools::list {
namespace {

using asset::JsonObject;
using nlohmann::ordered_json;

std::string entry_line(const SceneEntry& entry) {
  ordered_json line = {{"scene", entry.scene}, {"error", nullptr}, {"lines", entry.lines}};
  if (entry.error) {
    line["error"] = *entry.error;
    return output::json_text(line) + '\n';
  }
  line["frames"] = entry.frames;
  line["frames_in_contact"] = entry.frames_in_contact;
  line["contacts"] = entry.contacts;
  line["worst"] = nullptr;
  if (entry.worst > 0) line["worst"] = {{"frame", entry.worst_frame}, {"contacts", entry.worst}};
  line["hash"] = nullptr;
  if (entry.hash) line["hash"] = output::hex16(*entry.hash);
  line["failed"] = entry.is_failed;
  return output::json_text(line) + '\n';
}

void read_worst(const JsonObject& worst, SceneEntry& entry) {
  entry.worst = worst.count("contacts");
  entry.worst_frame = worst.index("frame", std::numeric_limits<std::uint32_t>::max());
}

void read_hash(const JsonObject& line, SceneEntry& entry) {
  if (!output::parse_hex16(line.text("hash"), entry.hash.emplace()))
    line.refuse("hash", "must be 16 hexadecimal digits");
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

Result<SceneEntry> read_entry(const std::string& text) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(text);
  if (!parsed) return parsed.error();
  asset::FirstError errors;
  const JsonObject line(**parsed, "", errors);
  if (errors.get()) return *errors.get();
  const nlohmann::json& object = **parsed;
  const auto has_value = [&](const char* key) {
    return line.has(key) && !object.find(key)->is_null();
  };
  SceneEntry entry;
  entry.scene = line.text("scene");
  if (!line.has("scene")) line.refuse("scene", "is missing");
  if (has_value("error")) {
    entry.error = line.text("error");
  } else {
    entry.lines = line.count("lines");
    entry.frames = line.count("frames");
    entry.frames_in_contact = line.count("frames_in_contact");
    entry.contacts = line.count("contacts");
    if (has_value("worst")) read_worst(line.object("worst"), entry);
    if (has_value("hash")) read_hash(line, entry);
    entry.is_failed = line.flag("failed");
  }
  if (errors.get()) return *errors.get();
  return entry;
}

std::optional<std::vector<std::string>> read_lines_of(const SceneEntry& entry, std::istream& in) {
  std::vector<std::string> lines;
  while (lines.size() < entry.lines)
    if (!read_line(in, lines.emplace_back())) return std::nullopt;
  return lines;
}

}  // namespace pelt::tools::list
