#pragma once

/// `PELT_API` marks what a shared library exports: every public function and class that is not
/// defined in a header. The libraries are compiled with hidden visibility, so nothing else is
/// exported.
///
/// On Windows, the users of the shared libraries define PELT_SHARED, as Pelt's CMake targets and
/// pkg-config files do. The libraries themselves also define PELT_BUILDING. Other systems need
/// neither macro, and use the same object files for static and shared libraries.

#if !defined(_WIN32)
#define PELT_API __attribute__((visibility("default")))
#elif !defined(PELT_SHARED)
#define PELT_API
#elif defined(PELT_BUILDING)
#define PELT_API __declspec(dllexport)
#else
#define PELT_API __declspec(dllimport)
#endif
