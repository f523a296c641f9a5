#pragma once

#include <pelt/result.hpp>

#include <string>
#include <utility>

namespace pelt::detail {

/// The first thing that a check finds wrong; empty: nothing.
using Problem = std::string;

/// As printf writes it, cut off after 255 characters.
Problem problem(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// The answer to a caller whose argument has a problem.
inline Error invalid_argument(Problem found) {
  return {ErrorCode::invalid_argument, std::move(found)};
}

}  // namespace pelt::detail
