#pragma once

/// Reports a single error if the compiler is not set to C++20. After `#error`, g++ and clang would
/// continue and report every declaration that they do not understand. Both compilers stop at a
/// missing include file, so this header includes a missing file whose name is the message.

#if !(__cplusplus > 201703L || (defined(_MSVC_LANG) && _MSVC_LANG > 201703L))
#if defined(__GNUC__)
#include <Pelt needs C++20: compile with -std=c++20>
#else
#error "Pelt needs C++20: compile with -std=c++20"
#endif
#endif
