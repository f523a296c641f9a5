#pragma once

namespace pelt::detail {

/// Prints `message` to stderr and aborts.
[[noreturn]] void abort_call(const char* message);

/// Checks a precondition in every build. For preconditions whose violation would give wrong answers
/// and whose check takes constant time. `message` names the function or the argument, and the cause
/// or the remedy.
/// Preconditions that take longer to check are asserts (base/assert.hpp).
inline void require(bool holds, const char* message) {
  if (!holds) [[unlikely]]
    abort_call(message);
}

}  // namespace pelt::detail
