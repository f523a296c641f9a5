#pragma once

#include <cassert>

/// A promise of the caller or of our own code. On wherever NDEBUG is not defined (the `dev` and
/// sanitizer presets); cheap enough to stay on there at full optimisation.
#define PELT_ASSERT(condition) assert(condition)
