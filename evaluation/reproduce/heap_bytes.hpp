#pragma once

#include <cstddef>
#include <optional>

namespace pelt::reproduce {

/// The bytes that the program has allocated and not freed; nothing where the C library does not
/// tell. O(number of the allocator's arenas).
std::optional<std::size_t> heap_bytes();

}  // namespace pelt::reproduce
