#pragma once

/// Makes text from files and command lines safe for a terminal.

#include <cstddef>
#include <string>
#include <string_view>

namespace pelt::text {

/// The first code point of a text in UTF-8.
struct CodePoint {
  static constexpr char32_t kNone = 0xFFFFFFFF;

  char32_t value = kNone;  ///< kNone: the first byte starts no code point
  std::size_t bytes = 1;
};

/// Precondition: `text` is not empty.
CodePoint first_code_point(std::string_view text);

/// Whether a terminal may interpret this code point instead of showing it: control characters (C0,
/// DEL and C1), line and paragraph separators, and characters that change the direction of writing.
bool steers_terminal(char32_t code_point);

/// Replaces every code point that controls a terminal, and every byte that is not UTF-8, by '?'.
std::string printable(std::string_view text);

/// Replaces every byte that is not UTF-8 by U+FFFD, the replacement character.
std::string as_utf8(std::string_view text);

/// Largest size in bytes of a name that is shown completely.
inline constexpr std::size_t kLongestName = 64;

/// A printable name. Truncates a name longer than kLongestName after a whole code point and appends
/// "...".
std::string printable_name(std::string_view name);

}  // namespace pelt::text
