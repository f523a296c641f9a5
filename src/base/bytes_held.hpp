#pragma once

#include <cstddef>

namespace pelt::detail {

/// Returns the bytes allocated by arrays, used or not.
template <typename... Arrays>
std::size_t bytes_held(const Arrays&... arrays) {
  // The elements may be pointers. NOLINTNEXTLINE(bugprone-sizeof-expression)
  return ((arrays.capacity() * sizeof(typename Arrays::value_type)) + ...);
}

}  // namespace pelt::detail
