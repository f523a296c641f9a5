#pragma once

#include <string>

namespace pelt::detail {

/// The first thing that a check finds wrong; empty: nothing.
using Problem = std::string;

/// As printf writes it.
Problem problem(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace pelt::detail
