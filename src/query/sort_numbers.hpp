#pragma once

#include "query/stack.hpp"

#include <cstdint>

namespace pelt::detail {

/// Puts numbers in ascending order. What is in `buffer` is lost.
void sort_numbers(Stack<std::uint32_t>& numbers, Stack<std::uint32_t>& buffer);

}  // namespace pelt::detail
