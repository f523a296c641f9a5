#pragma once

/// Small scenes and models as files.

#include "support/gltf_builder.hpp"
#include "tools/run_program.hpp"

#include <string>

namespace pelt::test {

void write_text(const std::filesystem::path& path, const std::string& text);
void write_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes);

/// A closed tube of 24 rings, 1 unit high along y, with a clip "sway" (1 s) that bends its joints.
std::vector<std::byte> swaying_limb(std::uint32_t sides);

/// The same for modification: one primitive in mesh 0, and "limb" as the last node.
GltfBuilder build_limb(std::uint32_t sides);

/// The limb, which bends so far that it passes through itself.
GltfBuilder build_curl();

/// Two limbs that pass through each other: apart in the first and last frames, in contact between.
inline constexpr const char* kLimbsScene = R"({
  "models": {"one": "one.glb", "two": "two.glb"},
  "frames": {"count": 12, "fps": 6},
  "instances": [
    {"model": "one", "clip": "sway", "translation": [-0.5, 0, 0], "velocity": [0.5, 0, 0]},
    {"model": "two", "clip": "sway", "start": 0.4, "translation": [0.5, 0, 0.03],
     "rotation": [0, 1, 0, 0], "velocity": [-0.5, 0, 0]}
  ]
})";

/// Writes kLimbsScene to scene.json of the folder, and its models. Returns its path.
std::string write_limbs(const TestFolder& folder);

/// A folder with the files of write_limbs.
struct LimbsFolder : TestFolder {
  LimbsFolder() { write_limbs(*this); }
};

/// paper_strip() with an unskinned sheet on its node "upper" that crosses the strip: parts "paper"
/// (6 triangles) and "fan" (2), clips "bend" (1 s) and one without a name.
GltfBuilder strip_with_fan();

/// Writes strip_with_fan() to `name` in the folder. Returns its path.
std::string write_strip(const TestFolder& folder, const std::string& name);

/// A folder with strip.glb.
struct StripFolder : TestFolder {
  StripFolder() { write_strip(*this, "strip.glb"); }
};

/// A page that replaces the viewer.
std::string viewer_page(const std::string& version);

/// Writes such a page to viewer.html in the folder, and makes the command use it.
class ViewerPage {
 public:
  explicit ViewerPage(const TestFolder& folder);
  ~ViewerPage();
};

/// The data that the command writes into a page.
json data_of(const std::string& page);

}  // namespace pelt::test
