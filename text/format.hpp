#pragma once

/// Numbers, lists and bytes as text, and back.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::text {

std::vector<std::string_view> split(std::string_view text, char separator);

/// Whether all of `text` is one number. Sets `value` to the number, or leaves it unchanged.
bool parse_whole(std::string_view text, std::uint32_t& value);
bool parse_number(std::string_view text, double& value);

/// "53,512"
std::string with_commas(std::uint64_t value);

/// printf's %.*f
std::string fixed(double value, int decimals);

/// "0123456789abcdef"
std::string hex16(std::uint64_t value);

/// Whether `text` is a result of hex16. Sets `value` to the number if so.
bool parse_hex16(std::string_view text, std::uint64_t& value);

/// "1 frame", "2 frames"
std::string counted(std::uint64_t count, const char* noun);

/// Encodes bytes as text (RFC 4648, section 4), for embedding in a page.
std::string base64(const std::string& bytes);

/// Quotes a word for a shell if necessary.
std::string shell_word(const std::string& word);

}  // namespace pelt::text
