#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pelt::detail {

/// Makes room for `count` more elements, so that appending them allocates nothing. Repeated calls
/// grow a list as fast as `push_back` does.
template <typename T>
void reserve_more(std::vector<T>& list, std::size_t count) {
  const std::size_t needed = list.size() + count;
  if (needed > list.capacity()) list.reserve(std::max(needed, 2 * list.capacity()));
}

}  // namespace pelt::detail
