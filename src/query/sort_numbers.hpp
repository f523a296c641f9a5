#pragma once

#include "query/stack.hpp"

#include <cstdint>

namespace pelt::detail {

/// Sorts numbers in ascending order. Overwrites `buffer`.
void sort_numbers(Stack<std::uint32_t>& numbers, Stack<std::uint32_t>& buffer);

}  // namespace pelt::detail
