#pragma once

/// The generated sword, which is thin and fast: between two frames it can pass through an arm that
/// it touches in no frame.

#include <pelt/asset.hpp>

namespace pelt::scenes {

/// Generates a sword of 26 triangles, 0.9 units long, along -x from its joint "grip" at the origin.
/// The clip "swing" (0.4 s) turns it around y by 180 degrees within 1/6 s, from +z to -z.
asset::Asset make_sword();

}  // namespace pelt::scenes
