#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <span>

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
