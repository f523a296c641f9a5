#pragma once

/// Keys of the scene format, object by object, as read by the parser and documented in
/// docs/scene.schema.json.

#include <array>
#include <string_view>

namespace pelt::scenes {

inline constexpr std::array<std::string_view, 10> kSceneKeys = {
    "$schema", "models",     "frames",       "instances",   "ignore",
    "self",    "self_rings", "self_at_rest", "self_always", "self_near_joints"};
inline constexpr std::array<std::string_view, 2> kFramesKeys = {"count", "fps"};
inline constexpr std::array<std::string_view, 4> kModelKeys = {"file", "creature", "face",
                                                               "skinning"};
inline constexpr std::array<std::string_view, 3> kCreatureKeys = {"triangles", "joints", "seed"};
inline constexpr std::array<std::string_view, 2> kFaceKeys = {"triangles", "seed"};
inline constexpr std::array<std::string_view, 9> kInstanceKeys = {
    "model",    "clip",  "start",    "speed",        "translation",
    "rotation", "scale", "velocity", "morph_weights"};

}  // namespace pelt::scenes
