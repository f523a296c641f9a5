#pragma once

/// Parses and formats numbers, and formats error messages.

#include <pelt/result.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::tools::output {

/// An error in the form that the command prints: "--frames: what is wrong: what to do".
inline Error bad_argument(const std::string& argument, const std::string& problem,
                          const std::string& remedy) {
  return {ErrorCode::invalid_argument, argument + ": " + problem + ": " + remedy};
}

/// The error for a number outside the allowed range: "--fps: "0" is not allowed: what to do".
Error number_not_allowed(const std::string& argument, double value, const std::string& remedy);

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

}  // namespace pelt::tools::output
