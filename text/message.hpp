#pragma once

/// Wording of errors.

#include <pelt/result.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace pelt::text {

inline Error malformed(std::string message) {
  return {ErrorCode::malformed_file, std::move(message)};
}

inline Error unsupported(std::string message) {
  return {ErrorCode::unsupported, std::move(message)};
}

/// Returns a name from a file in quotes, as shown by `printable_name`.
std::string quoted(std::string_view name);

/// Returns a label with the number and, if there is one, the name: `node 12 "Hips"`.
std::string label(std::string_view kind, std::size_t index, std::string_view name = {});

/// Prefixes the message of an error with the place of the error.
Error prefixed(std::string_view place, const Error& error);

/// An error in the form that the command prints: "--frames: what is wrong: what to do".
inline Error bad_argument(const std::string& argument, const std::string& problem,
                          const std::string& remedy) {
  return {ErrorCode::invalid_argument, argument + ": " + problem + ": " + remedy};
}

/// The error for a number outside the allowed range: "--fps: "0" is not allowed: what to do".
Error number_not_allowed(const std::string& argument, double value, const std::string& remedy);

/// Returns the known name that was probably meant, ignoring case: a name with at most one typing
/// error per three characters, or else the shortest name that contains `name`. O(length of `name`
/// times the length of all known names).
std::optional<std::string_view> closest_name(std::string_view name,
                                             std::span<const std::string_view> known);

/// Returns `, did you mean "clip"?` if a similar name is known, otherwise the first known names as
/// `, expected one of "model", "clip"`. Same cost as `closest_name`.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace pelt::text
