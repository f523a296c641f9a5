#pragma once

namespace pelt::detail {

/// Prints `message` to stderr and aborts.
[[noreturn]] void abort_call(const char* message);

/// A promise of the caller that is checked in every build: breaking it would give wrong answers,
/// and to check it takes constant time. `message` names the function, what is wrong and the remedy.
/// Promises that take longer to check are asserts (base/assert.hpp).
inline void require(bool holds, const char* message) {
  if (!holds) [[unlikely]]
    abort_call(message);
}

}  // namespace pelt::detail
