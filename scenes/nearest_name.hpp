#pragma once

/// Help for a name that is not among the known ones.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pelt::scenes {

/// The known name that was meant, upper and lower case aside: one with at most one typing error in
/// three characters, else the shortest that has `name` in it. O(length of `name` times the length
/// of all known ones).
std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> known);

/// `, did you mean "clip"?` where a name is near, else `, expected one of "model", "clip"`, the
/// first of them. Costs what `nearest_name` does.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace pelt::scenes
