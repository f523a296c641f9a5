#pragma once

/// Hot code is written once and compiled once for each instruction set: AVX2, four lanes (SSE4.1,
/// NEON, WASM) and scalar. Such files define everything in the inline namespace
/// PELT_INSTRUCTION_SET, so that the linker never confuses functions of different instruction sets.
/// `dispatch.hpp` chooses an instruction set at run time. All other code is compiled for the
/// baseline of the machine.
#ifndef PELT_INSTRUCTION_SET
#define PELT_INSTRUCTION_SET baseline
#endif
