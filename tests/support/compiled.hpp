#pragma once

/// Functions that are compiled once for each instruction set, by `pelt_wide_sources`, in files that
/// define them in namespace PELT_INSTRUCTION_SET. Includes little, because such a file must not
/// compile inline functions that others use on any machine.

#include <pelt/config.hpp>

namespace pelt::test {

/// Declares the functions of a name.
#define PELT_DECLARE_COMPILED(Function, name) \
  namespace avx2 {                            \
  Function name;                              \
  }                                           \
  namespace simd128 {                         \
  Function name;                              \
  }                                           \
  namespace scalar {                          \
  Function name;                              \
  }

template <typename Function>
struct Compiled {
  InstructionSet set;
  Function* call;
};

#ifdef PELT_HAS_SIMD128
#define PELT_COMPILED_FOR_SIMD128(name) {InstructionSet::simd128, simd128::name},
#else
#define PELT_COMPILED_FOR_SIMD128(name)
#endif
#ifdef PELT_HAS_AVX2
#define PELT_COMPILED_FOR_AVX2(name) {InstructionSet::avx2, avx2::name},
#else
#define PELT_COMPILED_FOR_AVX2(name)
#endif

/// The functions of a name that this build has, first the scalar one.
#define PELT_ALL_COMPILED(name)                                      \
  {                                                                  \
    {InstructionSet::scalar, scalar::name},                          \
        PELT_COMPILED_FOR_SIMD128(name) PELT_COMPILED_FOR_AVX2(name) \
  }

}  // namespace pelt::test
