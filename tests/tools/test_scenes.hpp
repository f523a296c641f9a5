#pragma once

/// Small scenes and models as files.

#include "support/gltf_builder.hpp"
#include "tools/run_program.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace pelt::test {

void write_text(const std::filesystem::path& path, const std::string& text);
void write_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes);

/// Two small creatures that walk through each other: 12 frames at 6 per second, in contact in some
/// of them and apart in others.
inline constexpr const char* kWalkersScene = R"({
  "models": {
    "one": {"creature": {"triangles": 1000, "joints": 24, "seed": 1}},
    "two": {"creature": {"triangles": 1200, "joints": 45, "seed": 2}}
  },
  "frames": {"count": 12, "fps": 6},
  "instances": [
    {"model": "one", "clip": "walk", "translation": [-0.1, 0, -0.9], "velocity": [0, 0, 0.9]},
    {"model": "two", "clip": "walk", "start": 0.4, "translation": [0.1, 0, 0.9],
     "rotation": [0, 1, 0, 0], "velocity": [0, 0, -0.9]}
  ]
})";

/// Writes kWalkersScene to scene.json of the folder; returns its path.
std::string write_walkers(const TestFolder& folder);

/// paper_strip() with a sheet that rides unskinned on its node "upper" and crosses the strip: parts
/// "paper" (6 triangles) and "fan" (2), clips "bend" (1 s) and one without a name.
GltfBuilder strip_with_fan();

/// Writes strip_with_fan() to `name` of the folder; returns its path.
std::string write_strip(const TestFolder& folder, const std::string& name);

}  // namespace pelt::test
