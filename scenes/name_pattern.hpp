#pragma once

#include <string_view>

namespace pelt::scenes {

/// Whether `text` is `pattern`, in which a `*` stands for any characters, also for none. O(length
/// of one times the other at worst).
bool matches(std::string_view pattern, std::string_view text);

}  // namespace pelt::scenes
