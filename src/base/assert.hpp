#pragma once

#include <cassert>

/// Asserts a precondition or an invariant. Active if NDEBUG is not defined (the `dev` and sanitizer
/// presets), and cheap enough to stay active at full optimisation. Otherwise the condition is
/// compiled, so that its variables count as used, but never evaluated.
#ifdef NDEBUG
#define PELT_ASSERT(condition) static_cast<void>(true || (condition))
#else
#define PELT_ASSERT(condition) assert(condition)
#endif
