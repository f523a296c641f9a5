#pragma once

/// `PELT_API` marks what a shared library exports: every public function and class that is not
/// defined in a header. The libraries are compiled with hidden visibility, so nothing else is
/// exported.

#if defined(__GNUC__)
#define PELT_API __attribute__((visibility("default")))
#else
#define PELT_API
#endif
