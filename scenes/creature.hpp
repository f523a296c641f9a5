#pragma once

/// The generated character: a smooth, closed, walking biped. Pelt ships no model files. The same
/// options give the same bits on every platform.

#include <pelt/asset.hpp>

#include <cstdint>

namespace pelt::scenes {

struct CreatureOptions {
  std::uint32_t triangles = 13590;  ///< 1,000 to 1,000,000; odd numbers are rounded down
  std::uint32_t joints = 56;        ///< 20 to 64
  std::uint32_t seed = 1;           ///< proportions
};

/// The sizes of the paper's characters (Kavan & Zara 2005, table 1).
inline constexpr CreatureOptions kDwarf = {1664, 45, 3};
inline constexpr CreatureOptions kMan = {8270, 27, 6};
inline constexpr CreatureOptions kCreature = {13590, 56, 1};

/// Speed of the clip "walk" in units per second. The clip walks on the spot; with this velocity
/// along its +z, the feet of an instance do not slide.
inline constexpr double kWalkSpeed = 0.75;

/// Generates a creature 1.8 units tall, y up, facing +z, feet on y = 0, with the looping clips
/// "walk" and "idle". It is one closed surface with exactly the given number of triangles and up to
/// four influences per vertex. Returns an error for options out of range.
///
/// Cost: O(T log T) for T triangles, and at least that of the coarsest surface with fingers; 13,590
/// triangles take a fraction of a second. Working memory is that of a surface with about 1.6 times
/// as many triangles, or of the coarsest one.
Result<asset::Asset> make_creature(const CreatureOptions& options = {});

}  // namespace pelt::scenes
