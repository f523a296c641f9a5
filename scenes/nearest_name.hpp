#pragma once

/// Help for a name that is not among the known ones.

#include <span>
#include <string>
#include <string_view>

namespace pelt::scenes {

/// `, did you mean "clip"?` where a known name is at most two typing errors away, else
/// `, expected one of "model", "clip"`. O(length of `name` times the length of all known ones).
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace pelt::scenes
