#pragma once

/// Hot code is written once and compiled once for each target: AVX2, four lanes (SSE4.1, NEON,
/// WASM) and scalar. Such files define everything in the inline namespace PELT_TARGET, so that the
/// linker never confuses functions of different targets. `dispatch.hpp` chooses a target at run
/// time. All other code is compiled for the baseline of the machine.
#ifndef PELT_TARGET
#define PELT_TARGET baseline
#endif
