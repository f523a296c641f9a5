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

#include <span>

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

namespace pelt {

/// Instruction sets for queries. All of them give the same answers, bit for bit, and count the same
/// work. They differ only in speed.
enum class InstructionSet {
  scalar,   ///< no vector instructions
  simd128,  ///< four floats at once: SSE4.1, NEON or WASM SIMD, depending on the build
  avx2,     ///< eight floats at once
};

/// Returns "scalar", "simd128" or "avx2".
PELT_API const char* name_of(InstructionSet set);

/// Returns the instruction sets that the build contains and the machine supports, slowest first.
PELT_API std::span<const InstructionSet> available_instruction_sets();

/// Returns the instruction set that queries use: the fastest available one, unless
/// `set_active_instruction_set` has selected another.
PELT_API InstructionSet active_instruction_set();

/// Makes all later queries use `set`, for measurements and tests. Returns false and changes nothing
/// if `set` is not available.
///
/// Precondition: no other thread runs a query during the call.
PELT_API bool set_active_instruction_set(InstructionSet set);

}  // namespace pelt
