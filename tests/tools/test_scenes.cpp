#include "tools/test_scenes.hpp"

#include <fstream>

namespace pelt::test {

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void write_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

std::string write_walkers(const TestFolder& folder) {
  write_text(folder / "scene.json", kWalkersScene);
  return folder / "scene.json";
}

GltfBuilder strip_with_fan() {
  GltfBuilder builder = paper_strip();
  const std::vector<float> sheet = {0.5f, 0, -1, 0.5f, 0, 1, 0.5f, 1, -1, 0.5f, 1, 1};
  const std::size_t positions = builder.add_accessor(sheet, "VEC3");
  const std::size_t indices =
      builder.add_accessor(std::vector<std::uint16_t>{0, 1, 2, 2, 1, 3}, "SCALAR");
  const json primitive = {{"attributes", {{"POSITION", positions}}}, {"indices", indices}};
  const std::size_t mesh = builder.add("meshes", {{"primitives", {primitive}}});
  const std::size_t node = builder.add("nodes", {{"name", "fan"}, {"mesh", mesh}});
  builder.document["nodes"][2]["children"] = {node};
  json unnamed = builder.document["animations"][0];
  unnamed.erase("name");
  builder.add("animations", unnamed);
  return builder;
}

std::string write_strip(const TestFolder& folder, const std::string& name) {
  write_bytes(folder / name, strip_with_fan().glb());
  return folder / name;
}

}  // namespace pelt::test
