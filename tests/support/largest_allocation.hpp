#pragma once

#include <cstddef>

namespace pelt::test {

/// The largest number of bytes in one call of operator new, since the start or since
/// `reset_largest_allocation`. Add largest_allocation.cpp to the program, which replaces operator
/// new.
std::size_t largest_allocation();

void reset_largest_allocation();

}  // namespace pelt::test
