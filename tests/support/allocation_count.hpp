#pragma once

#include <cstddef>

namespace pelt::test {

/// Number of calls of operator new so far. Link pelt_allocation_count, which replaces operator new.
std::size_t allocation_count();

}  // namespace pelt::test
