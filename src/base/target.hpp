#pragma once

/// The hot code is written once and compiled once for each target: AVX2, four lanes (SSE4.1, NEON,
/// WASM) and plain scalar. What such a file defines stands in the inline namespace PELT_TARGET, so
/// that the linker never takes one target's function for another's, and `dispatch.hpp` chooses
/// one target at run time. Everything else is compiled for the baseline of the machine.
#ifndef PELT_TARGET
#define PELT_TARGET baseline
#endif
