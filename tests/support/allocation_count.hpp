#pragma once

#include <cstddef>

namespace pelt::test {

/// Calls of operator new so far; linking pelt_allocation_count replaces it by one that counts.
std::size_t allocation_count();

}  // namespace pelt::test
