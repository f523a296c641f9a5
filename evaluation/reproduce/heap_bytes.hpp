#pragma once

#include <cstddef>
#include <optional>

namespace pelt::reproduce {

/// Bytes that the program has allocated and not freed; nullopt if the C library does not provide
/// it. O(number of the allocator's arenas).
std::optional<std::size_t> heap_bytes();

}  // namespace pelt::reproduce
