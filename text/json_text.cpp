#include "text/json_text.hpp"

#include "text/printable.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace pelt::text {
namespace {

bool is_plain(char c) { return static_cast<unsigned char>(c) < 0x7F; }

/// The escape of a code point of the basic plane, which contains all code points that control
/// terminals.
std::string escape(char32_t code_point) {
  char text[sizeof "\\u0000"];
  std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned>(code_point));
  return text;
}

/// nlohmann::json escapes control characters below U+0020, but no others.
std::string escape_steering(std::string_view json) {
  std::string text;
  while (!json.empty()) {
    const auto plain = std::find_if_not(json.begin(), json.end(), is_plain);
    const auto count = static_cast<std::size_t>(plain - json.begin());
    text.append(json.substr(0, count));
    json.remove_prefix(count);
    if (json.empty()) break;
    const CodePoint point = first_code_point(json);
    if (steers_terminal(point.value))
      text += escape(point.value);
    else
      text.append(json.substr(0, point.bytes));
    json.remove_prefix(point.bytes);
  }
  return text;
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value, int indent) {
  using nlohmann::ordered_json;
  std::string text = value.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
  return std::all_of(text.begin(), text.end(), is_plain) ? text : escape_steering(text);
}

}  // namespace pelt::text
