#pragma once

/// Suggestions for unknown names.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pelt::scenes {

/// Returns the known name that was probably meant, ignoring case: a name with at most one typing
/// error per three characters, or else the shortest name that contains `name`. O(length of `name`
/// times the length of all known names).
std::optional<std::string_view> closest_name(std::string_view name,
                                             std::span<const std::string_view> known);

/// Returns `, did you mean "clip"?` if a similar name is known, otherwise the first known names as
/// `, expected one of "model", "clip"`. Same cost as `closest_name`.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace pelt::scenes
