#pragma once

/// Scenes and models of `pelt demo`, and others that are made by code.

#include <pelt/asset.hpp>

#include <string_view>
#include <vector>

namespace pelt::scenes {

/// Two generated characters walk into each other: the scene of `pelt demo`, and the first scene of
/// the page. They walk without sliding (1.2 kWalkSpeed), out of step, and touch with shoulders and
/// arms.
inline constexpr std::string_view kDemoScene = R"({
  "models": {
    "azure": {"creature": {"triangles": 32000, "joints": 56, "seed": 1}},
    "sand": {"creature": {"triangles": 32000, "joints": 56, "seed": 2}}
  },
  "frames": {"count": 90, "fps": 30},
  "instances": [
    {"model": "azure", "clip": "walk", "start": -0.267, "speed": 1.2,
     "translation": [-0.11, 0, -1.35], "velocity": [0, 0, 0.9]},
    {"model": "sand", "clip": "walk", "start": 0.353, "speed": 1.2,
     "translation": [0.11, 0, 1.35], "rotation": [0, 1, 0, 0], "velocity": [0, 0, -0.9]}
  ]
}
)";

/// A sword that swings through the left forearm of the first character of the demo. It is before
/// the arm in frame 5, behind it in frame 6, and touches it in no frame.
inline constexpr std::string_view kSwordScene = R"({
  "models": {"azure": "azure.glb", "sword": "sword.glb"},
  "frames": {"count": 12, "fps": 30},
  "instances": [
    {"model": "azure", "clip": "idle"},
    {"model": "sword", "clip": "swing", "translation": [1.2, 0.76, 0]}
  ]
}
)";

/// Generates a sword of 26 triangles, 0.9 units long, along -x from its joint "grip" at the origin.
/// The clip "swing" (0.4 s) turns it around y by 180 degrees within 1/6 s, from +z to -z.
asset::Asset make_sword();

/// Returns the palette of a creature in its rest pose, with the left forearm and the hand turned
/// about the axis of the forearm by this fraction of a turn. Precondition: `creature` is the result
/// of make_creature.
std::vector<Matrix4> twisted_arm(const asset::Asset& creature, double turns);

}  // namespace pelt::scenes
