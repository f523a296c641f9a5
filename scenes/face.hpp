#pragma once

/// The generated face: the head of a generated character as a bust, with morph targets. For tests
/// and demonstrations of morph targets without a model file.

#include <pelt/asset.hpp>

#include <cstdint>

namespace pelt::scenes {

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

}  // namespace pelt::scenes
