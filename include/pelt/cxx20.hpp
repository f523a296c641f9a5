#pragma once

/// Stops compilers that do not compile C++20 with one line. After `#error` g++ and clang read on
/// and report every declaration that they do not understand. A missing file ends the compilation,
/// so there the name of the missing file is the message.

#if !(__cplusplus > 201703L || (defined(_MSVC_LANG) && _MSVC_LANG > 201703L))
#if defined(__GNUC__)
#include <Pelt needs C++20: compile with -std=c++20>
#else
#error "Pelt needs C++20: compile with -std=c++20"
#endif
#endif
