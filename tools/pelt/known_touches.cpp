#include "tools/pelt/known_touches.hpp"

#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools {
namespace {

using asset::FirstError;
using asset::JsonObject;

constexpr const char* kRemedy =
    "name a file that pelt check --jsonl wrote, with the same --by and --clearance and no limit";

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

std::string_view last_line(std::string_view text) {
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  const std::size_t end = text.rfind('\n');
  return end == std::string_view::npos ? text : text.substr(end + 1);
}

TouchName read_name(const JsonObject& object) {
  constexpr std::size_t kAnyInstance = std::size_t{1} << 32;
  return {object.index("instance", kAnyInstance), object.text("model"), object.text("part"),
          object.text("joint")};
}

/// A number, or nothing where it is absent or null.
std::optional<double> number_or_null(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

void require_same_question(const nlohmann::json& value, const CheckQuestion& question,
                           FirstError& errors) {
  const JsonObject header(value, "", errors);
  if (header.text("format") != "pelt-check") header.refuse("format", "must be pelt-check");
  if (header.count("version") != 1) header.refuse("version", "must be 1");
  const JsonObject shown = header.object("options");
  if (!header.is_object("options")) return;
  const nlohmann::json& theirs = value["options"];
  if (shown.text("by") != question.by) shown.refuse("by", "is not " + question.by + " as here");
  if (number_or_null(theirs, "clearance") != question.clearance)
    shown.refuse("clearance", "is not as here");
  if (number_or_null(theirs, "max_contacts")) shown.refuse("max_contacts", "left contacts out");
}

Error unusable(const std::string& path, const Error& error) {
  return {error.code, "--baseline: " + path + ": " + error.message + ": " + kRemedy};
}

}  // namespace

Result<KnownTouches> KnownTouches::parse(const std::string& path, std::string_view text,
                                         const CheckQuestion& question) {
  const Result<nlohmann::json> header = asset::parse_json(first_line(text));
  if (!header) return unusable(path, header.error());
  const Result<nlohmann::json> totals = asset::parse_json(last_line(text));
  if (!totals) return unusable(path, totals.error());
  FirstError errors;
  require_same_question(*header, question, errors);
  const JsonObject last(*totals, "", errors);
  if (!last.has("touches")) last.refuse("touches", "is missing from the last line");
  KnownTouches known;
  for (const JsonObject& touch : last.objects("touches")) {
    known.worst_[{read_name(touch.object("a")), read_name(touch.object("b"))}] =
        touch.object("worst").count("contacts");
  }
  if (errors.get()) return unusable(path, *errors.get());
  return known;
}

Result<KnownTouches> KnownTouches::read(const std::string& path, const CheckQuestion& question) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return unusable(path, bytes.error());
  return parse(path, {reinterpret_cast<const char*>(bytes->data()), bytes->size()}, question);
}

std::uint64_t KnownTouches::worst(const TouchName& a, const TouchName& b) const {
  const auto found = worst_.find({a, b});
  return found == worst_.end() ? 0 : found->second;
}

}  // namespace pelt::tools
