#pragma once

/// Checks of preconditions and invariants.

#include <cassert>

/// Asserts a precondition or an invariant. Active if NDEBUG is not defined (the `dev` and sanitizer
/// presets), and cheap enough to stay active at full optimisation. Otherwise the condition is
/// compiled, so that its variables count as used, but never evaluated.
#ifdef NDEBUG
#define PELT_ASSERT(condition) static_cast<void>(true || (condition))
#else
#define PELT_ASSERT(condition) assert(condition)
#endif

namespace pelt::detail {

/// Prints `message` to stderr and aborts.
[[noreturn]] void abort_call(const char* message);

/// Checks a precondition in every build. For preconditions whose violation would give wrong answers
/// and whose check takes constant time; others are asserted. `message` names the function or the
/// argument, and the cause or the remedy.
inline void require(bool holds, const char* message) {
  if (!holds) [[unlikely]]
    abort_call(message);
}

}  // namespace pelt::detail
