#pragma once

/// The generated character: a smooth, closed, walking biped made by code, since Pelt ships no
/// model files. Deterministic: the same options give the same bits on every platform.

#include <pelt/asset.hpp>

#include <cstdint>

namespace pelt::scenes {

struct CreatureOptions {
  std::uint32_t triangles = 13590;  ///< 1,000 to 1,000,000; an odd number gives one less
  std::uint32_t joints = 56;        ///< 20 to 64
  std::uint32_t seed = 1;           ///< proportions
};

/// The sizes of the paper's characters (Kavan & Zara 2005, table 1).
inline constexpr CreatureOptions kDwarf = {1664, 45, 3};
inline constexpr CreatureOptions kMan = {8270, 27, 6};
inline constexpr CreatureOptions kCreature = {13590, 56, 1};

/// Units per second at which the ground passes under the clip "walk", which walks on the spot: give
/// an instance this velocity along its +z and its feet do not slide.
inline constexpr double kWalkSpeed = 0.75;

/// A creature 1.8 units tall, y up, facing +z, feet on y = 0, with the clips "walk" and "idle",
/// both loops. One closed surface of exactly the triangles asked for, up to four influences a
/// vertex. Refuses options out of range. O(T log T) with T triangles, beside what the coarsest
/// surface costs that has all fingers; 13,590 take a fraction of a second. Memory on the way is
/// that of a surface about 1.6 times as fine, or of the coarsest one.
Result<asset::Asset> make_creature(const CreatureOptions& options = {});

}  // namespace pelt::scenes
