#pragma once

/// The generated face: the head of a generated character as a bust, with morph targets. For all
/// that is asked of these, where no file is at hand that may be shown.

#include <pelt/asset.hpp>

#include <cstdint>

namespace pelt::scenes {

struct FaceOptions {
  std::uint32_t triangles = 4000;  ///< 1,000 to 200,000; an odd number gives one less
  std::uint32_t seed = 1;          ///< proportions, those of the creature with this seed
};

/// A face y up, facing +z, its neck on y = 0: one closed surface of exactly the triangles asked
/// for, 7 joints, and the morph targets "jaw_open", "smile", "blink_l", "blink_r", "brows_up" and
/// "cheeks_puffed", each of which displaces a part of the vertices. In the clip "talk", a loop, the
/// joints move and the weights too, all of which are zero now and then. Deterministic as the
/// creature. Refuses options out of range. O(T log T) with T triangles.
Result<asset::Asset> make_face(const FaceOptions& options = {});

}  // namespace pelt::scenes
