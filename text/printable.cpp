#include "text/printable.hpp"

#include <algorithm>

namespace pelt::text {

namespace {

/// Number of bytes of a code point that starts with `lead`; 0 if none does.
std::size_t length_by(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead < 0xC2) return 0;  // a later byte, or an overlong ASCII character
  if (lead < 0xE0) return 2;
  if (lead < 0xF0) return 3;
  return lead < 0xF5 ? 4 : 0;
}

/// Rejects overlong forms, surrogates and values beyond Unicode.
bool is_valid(char32_t value, std::size_t bytes) {
  if (bytes == 3) return value >= 0x800 && (value < 0xD800 || value > 0xDFFF);
  return bytes != 4 || (value >= 0x10000 && value <= 0x10FFFF);
}

bool is_between(char32_t value, char32_t first, char32_t last) {
  return value >= first && value <= last;
}

}  // namespace

CodePoint first_code_point(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = length_by(lead);
  if (length == 0 || length > text.size()) return {};
  if (length == 1) return {lead, 1};
  char32_t value = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0u) != 0x80) return {};
    value = value << 6 | (byte & 0x3Fu);
  }
  return is_valid(value, length) ? CodePoint{value, length} : CodePoint{};
}

bool steers_terminal(char32_t code_point) {
  return code_point < 0x20 || is_between(code_point, 0x7F, 0x9F) || code_point == 0x061C ||
         is_between(code_point, 0x200E, 0x200F) || is_between(code_point, 0x2028, 0x202E) ||
         is_between(code_point, 0x2066, 0x2069);
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = first_code_point(text.substr(i));
    if (point.value == CodePoint::kNone || steers_terminal(point.value))
      shown += '?';
    else
      shown += text.substr(i, point.bytes);
    i += point.bytes;
  }
  return shown;
}

std::string as_utf8(std::string_view text) {
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = first_code_point(text.substr(i));
    valid += point.value == CodePoint::kNone ? "\xEF\xBF\xBD" : text.substr(i, point.bytes);
    i += point.bytes;
  }
  return valid;
}

std::string printable_name(std::string_view name) {
  if (name.size() <= kLongestName) return printable(name);
  std::size_t end = 0;
  for (std::size_t next = 0; next <= kLongestName;) {
    end = next;
    next += first_code_point(name.substr(next)).bytes;
  }
  return printable(name.substr(0, end)) + "...";
}

}  // namespace pelt::text
