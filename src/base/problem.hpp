#pragma once

/// Problems of arguments, as text and as errors.

#include <pelt/result.hpp>

#include <string>
#include <utility>

namespace pelt::detail {

/// The first problem that a check finds; empty if there is none.
using Problem = std::string;

/// Formats a problem like printf, truncated to 255 characters.
Problem problem(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// Returns the error for an argument with a problem.
inline Error invalid_argument(Problem found) {
  return {ErrorCode::invalid_argument, std::move(found)};
}

}  // namespace pelt::detail
