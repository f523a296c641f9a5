#pragma once

/// The generated character: a smooth, closed, walking biped made by code, since Pelt ships no
/// model files. Deterministic: the same parameters give the same bits on every platform.

#include <pelt/asset.hpp>

#include <cstdint>

namespace pelt::scenes {

struct CreatureOptions {
  std::uint32_t triangles = 13590;  ///< 1,000 to 1,000,000; met within 1 %, the paper's sizes
                                    ///< (1664, 8270, 13590) exactly
  std::uint32_t joints = 56;        ///< 20 to 64; the paper's: 45, 27, 56
  std::uint32_t seed = 1;           ///< proportions
};

/// A creature of about 1.8 units, y up, facing +z, feet on y = 0, with the clips "walk" (a loop) and
/// "idle". Refuses parameters out of range.
Result<asset::Asset> make_creature(const CreatureOptions& options = {});

}  // namespace pelt::scenes
