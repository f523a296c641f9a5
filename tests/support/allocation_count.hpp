#pragma once

#include <cstddef>

/// Counts calls of operator new. Link pelt_allocation_count, which replaces operator new.
namespace pelt::test {

/// Number of calls so far.
std::size_t allocation_count();

/// The largest number of bytes in one call, since the start or since `reset_largest_allocation`.
std::size_t largest_allocation();
void reset_largest_allocation();

}  // namespace pelt::test
