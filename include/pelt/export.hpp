#pragma once

/// `PELT_API` marks the public functions and classes that a shared library exports. Functions and
/// classes that a header defines completely need no mark. The libraries are compiled with hidden
/// visibility, so nothing else is exported.
///
/// On Windows, code that uses the shared libraries is compiled with PELT_SHARED, which Pelt's CMake
/// targets and pkg-config files define. The shared libraries themselves are compiled with
/// PELT_SHARED and PELT_BUILDING. Other systems need neither macro, and use the same object files
/// for static and shared libraries.

#if !defined(_WIN32)
#define PELT_API __attribute__((visibility("default")))
#elif !defined(PELT_SHARED)
#define PELT_API
#elif defined(PELT_BUILDING)
#define PELT_API __declspec(dllexport)
#else
#define PELT_API __declspec(dllimport)
#endif
