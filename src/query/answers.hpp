#pragma once

/// Helpers with which queries write their answers.

#include <pelt/query.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// The answer of a query that stops at its first result. Stopping there is the regular end, so
/// nothing was cut short.
inline YesNo yes_or_no(bool answer, const QueryStats& stats) {
  YesNo result = {stats, answer};
  result.cut_short = false;
  return result;
}

/// Makes room for `count` more elements, so that appending them allocates nothing. Repeated calls
/// grow a list as fast as `push_back` does.
template <typename T>
void reserve_more(std::vector<T>& list, std::size_t count) {
  const std::size_t needed = list.size() + count;
  if (needed > list.capacity()) list.reserve(std::max(needed, 2 * list.capacity()));
}

/// Gives Pelt access to private members of public types.
struct Access {
  template <std::size_t kNumbers>
  static TreeLocation<kNumbers> location(const std::array<std::uint32_t, kNumbers>& numbers) {
    TreeLocation<kNumbers> location;
    location.numbers_ = numbers;
    return location;
  }

  template <std::size_t kNumbers>
  static const std::array<std::uint32_t, kNumbers>& numbers(
      const TreeLocation<kNumbers>& location) {
    return location.numbers_;
  }
};

}  // namespace pelt::detail
