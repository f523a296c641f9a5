#include "tools/test_scenes.hpp"

#include <pelt/version.hpp>

#include "support/skinned_shapes.hpp"

#include <cstdlib>
#include <fstream>

namespace pelt::test {
namespace {

void add_limb_mesh(const Shape& limb, GltfBuilder& builder) {
  std::vector<std::uint32_t> indices;
  std::vector<float> positions;
  for (const Triangle& t : limb.triangles) indices.insert(indices.end(), t.begin(), t.end());
  for (const Vec3& p : limb.rest_positions) positions.insert(positions.end(), {p.x, p.y, p.z});
  const json attributes = {{"POSITION", builder.add_accessor(positions, "VEC3")},
                           {"JOINTS_0", builder.add_accessor(limb.joints, "VEC4")},
                           {"WEIGHTS_0", builder.add_accessor(limb.weights, "VEC4")}};
  const std::size_t index_accessor = builder.add_accessor(indices, "SCALAR");
  const json primitive = {{"attributes", attributes}, {"indices", index_accessor}};
  builder.add("meshes", {{"primitives", {primitive}}});
}

/// Nodes 0 to count - 1, each the child of the previous one, at equal intervals from y = 0 to y =
/// 1.
void add_joint_chain(std::uint32_t count, GltfBuilder& builder) {
  const float step = 1.0f / static_cast<float>(count - 1);
  std::vector<float> inverse_binds;
  json joints = json::array();
  for (std::uint32_t j = 0; j < count; ++j) {
    const float y = step * static_cast<float>(j);
    inverse_binds.insert(inverse_binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -y, 0, 1});
    json node = {{"name", "joint " + std::to_string(j)}};
    if (j > 0) node["translation"] = {0, step, 0};
    if (j + 1 < count) node["children"] = {j + 1};
    joints.push_back(builder.add("nodes", node));
  }
  builder.add("skins", {{"joints", joints},
                        {"inverseBindMatrices", builder.add_accessor(inverse_binds, "MAT4")}});
}

/// Every joint except the first rotates about x and back.
void add_sway(std::uint32_t count, GltfBuilder& builder) {
  const std::vector<float> quaternions = {0, 0, 0, 1, 0.28f, 0, 0, 0.96f, 0, 0, 0, 1};
  const std::size_t times = builder.add_accessor(std::vector<float>{0, 0.5f, 1}, "SCALAR");
  const json sampler = {{"input", times}, {"output", builder.add_accessor(quaternions, "VEC4")}};
  json channels = json::array();
  for (std::uint32_t j = 1; j < count; ++j) {
    channels.push_back({{"sampler", 0}, {"target", {{"node", j}, {"path", "rotation"}}}});
  }
  builder.add("animations", {{"name", "sway"}, {"channels", channels}, {"samplers", {sampler}}});
}

}  // namespace

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void write_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

GltfBuilder build_limb(std::uint32_t sides) {
  constexpr std::uint32_t kJoints = 4;
  const Shape limb = make_limb(24, sides, kJoints);
  GltfBuilder builder;
  add_limb_mesh(limb, builder);
  add_joint_chain(kJoints, builder);
  add_sway(kJoints, builder);
  builder.add("nodes", {{"name", "limb"}, {"mesh", 0}, {"skin", 0}});
  builder.add("scenes", {{"nodes", {0, kJoints}}});
  return builder;
}

std::vector<std::byte> swaying_limb(std::uint32_t sides) { return build_limb(sides).glb(); }

std::string write_limbs(const TestFolder& folder) {
  write_bytes(folder / "one.glb", swaying_limb(24));
  write_bytes(folder / "two.glb", swaying_limb(20));
  write_text(folder / "scene.json", kLimbsScene);
  return folder / "scene.json";
}

GltfBuilder build_curl() {
  GltfBuilder builder = build_limb(8);
  const std::vector<float> quaternions = {0, 0, 0, 1, 0.966f, 0, 0, 0.259f, 0, 0, 0, 1};
  const std::size_t output = builder.add_accessor(quaternions, "VEC4");
  builder.document["animations"][0]["samplers"][0]["output"] = output;
  return builder;
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

std::string viewer_page(const std::string& version) {
  return R"(<html><meta name="generator" content="Pelt )" + version +
         R"("><p id="pelt-verdict"></p><script type="application/json" id="pelt-data"></script><p>viewer</p></html>)";
}

ViewerPage::ViewerPage(const TestFolder& folder) {
  write_text(folder / "viewer.html", viewer_page(PELT_VERSION));
  EXPECT_EQ(setenv("PELT_VIEWER", (folder / "viewer.html").c_str(), 1), 0);
}

ViewerPage::~ViewerPage() { unsetenv("PELT_VIEWER"); }

json data_of(const std::string& page) {
  const std::string open = R"(id="pelt-data">)";
  const std::size_t begin = page.find(open) + open.size();
  return json::parse(page.substr(begin, page.find("</script>") - begin));
}

}  // namespace pelt::test
