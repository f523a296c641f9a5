#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <span>

namespace pelt {

/// The instructions that queries use. All targets give the same answers, to the bit, and do the
/// same work; they differ in speed.
enum class Target {
  scalar,   ///< no vector instructions
  simd128,  ///< four floats at once: SSE4.1, NEON or WASM SIMD, whichever the library was built for
  avx2,     ///< eight floats at once
};

/// "scalar", "simd128" or "avx2".
PELT_API const char* name_of(Target target);

/// The targets that this build has and this machine can run, slowest first.
PELT_API std::span<const Target> available_targets();

/// What queries use: the fastest available target, unless `set_active_target` chose another.
PELT_API Target active_target();

/// Makes all queries from now on use `target`; false, and nothing changes, if it is not available.
/// For measurements and tests. Not while another thread runs a query.
PELT_API bool set_active_target(Target target);

}  // namespace pelt
