#pragma once

/// Chooses at run time which version of a function to call. A file that is compiled for each
/// instruction set defines `f` in the inline namespace PELT_INSTRUCTION_SET. `dispatch.cpp` in the
/// same folder is compiled once, for the baseline, and defines the `f` that all other baseline
/// files call:
///
///     PELT_DECLARE_VERSIONS(f)
///
///     inline namespace PELT_INSTRUCTION_SET {
///     int f(int argument) { return PELT_CHOOSE(f)(argument); }
///     }
///
/// A build with one instruction set, such as WebAssembly, calls the only version directly.

#include <pelt/config.hpp>

#include "base/instruction_set.hpp"

#include <atomic>

// A declared name cannot be in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)

/// For an instruction set that the build does not have, declares nothing, and the pointer is null.
#ifdef PELT_HAS_SCALAR
#define PELT_SCALAR_VERSION(function) scalar::function
#define PELT_DECLARE_SCALAR(function)           \
  namespace scalar {                            \
  extern decltype(baseline::function) function; \
  }
#else
#define PELT_SCALAR_VERSION(function) nullptr
#define PELT_DECLARE_SCALAR(function)
#endif

#ifdef PELT_HAS_SIMD128
#define PELT_SIMD128_VERSION(function) simd128::function
#define PELT_DECLARE_SIMD128(function)          \
  namespace simd128 {                           \
  extern decltype(baseline::function) function; \
  }
#else
#define PELT_SIMD128_VERSION(function) nullptr
#define PELT_DECLARE_SIMD128(function)
#endif

#ifdef PELT_HAS_AVX2
#define PELT_AVX2_VERSION(function) avx2::function
#define PELT_DECLARE_AVX2(function)             \
  namespace avx2 {                              \
  extern decltype(baseline::function) function; \
  }
#else
#define PELT_AVX2_VERSION(function) nullptr
#define PELT_DECLARE_AVX2(function)
#endif

// NOLINTEND(bugprone-macro-parentheses)

/// Declares the version of `function` of each instruction set. Precondition: a header declares
/// `function` in the surrounding namespace for the baseline, and it is not overloaded.
#define PELT_DECLARE_VERSIONS(function) \
  PELT_DECLARE_SCALAR(function)         \
  PELT_DECLARE_SIMD128(function)        \
  PELT_DECLARE_AVX2(function)

/// Points to the version of `function` of the active instruction set.
#define PELT_CHOOSE(function)                           \
  ::pelt::detail::choose<decltype(baseline::function)>( \
      PELT_SCALAR_VERSION(function), PELT_SIMD128_VERSION(function), PELT_AVX2_VERSION(function))

namespace pelt::detail {

inline constexpr int kNotChosen = -1;

/// The active instruction set, or kNotChosen before the first query. A plain number, so that a
/// query with cold caches loads it with one miss.
extern std::atomic<int> active_set;

/// Makes the fastest instruction set of this machine the active one, unless one has been chosen.
/// Returns the active one.
InstructionSet choose_instruction_set();

inline InstructionSet active() {
  const int set = active_set.load(std::memory_order_relaxed);
  return set == kNotChosen ? choose_instruction_set() : static_cast<InstructionSet>(set);
}

/// Returns the version of the active instruction set. At least one is not null.
template <typename Function>
inline Function* choose(Function* scalar, Function* simd128, Function* avx2) {
  if (!simd128 && !avx2) return scalar;
  if (!scalar && !avx2) return simd128;
  switch (active()) {
    case InstructionSet::scalar:
      return scalar;
    case InstructionSet::simd128:
      return simd128;
    case InstructionSet::avx2:
      return avx2;
  }
  return scalar;
}

}  // namespace pelt::detail
