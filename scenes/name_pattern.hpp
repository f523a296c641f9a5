#pragma once

#include <string_view>

namespace pelt::scenes {

/// Whether `text` matches `pattern`, in which a `*` matches any number of characters. O(length of
/// `text` times length of `pattern`) in the worst case.
bool matches(std::string_view pattern, std::string_view text);

}  // namespace pelt::scenes
