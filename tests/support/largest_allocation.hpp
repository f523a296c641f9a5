#pragma once

#include <cstddef>

namespace pelt::test {

/// The most bytes that operator new has been asked for at once; a program that has
/// largest_allocation.cpp among its sources has an operator new that keeps count.
std::size_t largest_allocation();

}  // namespace pelt::test
