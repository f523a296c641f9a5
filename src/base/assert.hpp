#pragma once

#include <cassert>

/// A promise of the caller or of our own code. On wherever NDEBUG is not defined (the `dev` and
/// sanitizer presets); cheap enough to stay on there at full optimisation. Elsewhere it is
/// compiled, so that its variables count as used, and never evaluated.
#ifdef NDEBUG
#define PELT_ASSERT(condition) static_cast<void>(true || (condition))
#else
#define PELT_ASSERT(condition) assert(condition)
#endif
