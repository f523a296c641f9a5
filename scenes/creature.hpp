#pragma once

/// Generated characters: a smooth, closed, walking biped, and the head of one as a bust with morph
/// targets. Pelt ships no model files. The same options give the same bits on every platform.

#include <pelt/asset.hpp>

#include <cstdint>
#include <string>

namespace pelt::scenes {

/// "creature: triangles is 3, expected 1000 to 1000000", or nothing if `value` is in the range.
inline std::string check_range(const char* what, const char* name, std::uint32_t value,
                               std::uint32_t low, std::uint32_t high) {
  if (value >= low && value <= high) return {};
  return std::string(what) + ": " + name + " is " + std::to_string(value) + ", expected " +
         std::to_string(low) + " to " + std::to_string(high);
}

struct FaceOptions {
  std::uint32_t triangles = 4000;  ///< 1,000 to 200,000; odd numbers are rounded down
  std::uint32_t seed = 1;          ///< proportions, those of the creature with this seed
};

/// Generates a face, y up, facing +z, with the neck on y = 0. It is one closed surface with exactly
/// the given number of triangles, 7 joints, and the morph targets "jaw_open", "smile", "blink_l",
/// "blink_r", "brows_up" and "cheeks_puffed", each of which displaces a part of the vertices. The
/// looping clip "talk" animates joints and weights; all weights are zero at some times.
/// Deterministic like the creature. Returns an error for options out of range. O(T log T) for T
/// triangles.
Result<asset::Asset> make_face(const FaceOptions& options = {});

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
