/// The fuzz target of scene files: bytes -> parse_scene_file. Also builds a scene of one generated
/// character, writes it as text and parses it again, which must give the same text.

#include "base/hash.hpp"
#include "fuzz/goal.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/scene_text.hpp"
#include "support/require.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::test {
namespace {

Goal scene_written("a scene that is written and parsed again"),
    file_refused("parse_scene_file: an error"), scene_refused("parse_scene: an error");

/// Whether to generate the characters of a text, which takes seconds with sanitizers. True for one
/// text in 64. (White space at the end of a seed makes it one of them.)
bool is_chosen(std::string_view text) {
  detail::Fnv1a64 hash;
  hash.add_bytes(std::as_bytes(std::span(text)));
  return (hash.value() >> 32) % 64 == 0;
}

/// Whether all characters are generated and small, and none is a file on this machine.
bool is_small(const scenes::SceneFile& file) {
  if (file.models.size() != 1 || file.instances.size() > 20) return false;
  const auto* creature = std::get_if<scenes::CreatureOptions>(&file.models[0].source);
  const auto* face = std::get_if<scenes::FaceOptions>(&file.models[0].source);
  return (creature != nullptr && creature->triangles <= 2000) ||
         (face != nullptr && face->triangles <= 2000);
}

void use_scene_text(std::string_view text) {
  const Result<scenes::SceneFile> file = scenes::parse_scene_file(text);
  file_refused.reach(!file);
  if (!file) return require(!file.error().message.empty(), "an error without a message");
  if (!is_small(*file) || !is_chosen(text)) return;
  const Result<scenes::Scene> scene = scenes::parse_scene(text, "no/such/folder", {});
  scene_refused.reach(!scene);
  if (!scene) return;
  const std::vector<std::string> paths(scene->characters.size());
  const std::string written = scenes::scene_text(*scene, paths);
  const Result<scenes::Scene> again = scenes::parse_scene(written, "no/such/folder", {});
  require(static_cast<bool>(again), "a written scene cannot be read");
  require(scenes::scene_text(*again, paths) == written, "a scene changes when it is written");
  scene_written.reach();
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pelt::test::use_scene_text({reinterpret_cast<const char*>(data), size});
  return 0;
}
