#include "tools/glb_file.hpp"
#include "tools/test_scenes.hpp"

#include <pelt/pelt.hpp>

#include "scenes/scene.hpp"

namespace pelt::test {
namespace {

/// The posed vertices, computed with the public functions only.
std::vector<Vec3> posed_by_library(const scenes::Scene& scene, std::uint32_t instance,
                                   std::uint32_t frame) {
  const asset::Asset& asset = scene.characters[scene.instances[instance].character].asset;
  Result<SkinnedModel> model = build_model(asset.mesh());
  EXPECT_TRUE(model);
  Pose pose(*model);
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  scenes::instance_palette(scene, instance, frame, scratch, palette);
  EXPECT_TRUE(pose.set_palette(palette));
  std::vector<Vec3> positions(model->vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

TEST(PoseVerb, WritesTheBitsThatAreCollided) {
  const TestFolder folder;
  const auto scene = scenes::load_scene(write_limbs(folder));
  ASSERT_TRUE(scene) << scene.error().message;
  const Ended run = run_pelt(folder, 0, {"pose", "scene.json", "--frame", "5", "-o", "a.glb"});
  EXPECT_EQ(run.out + run.err, "wrote a.glb\n");
  const GlbFile file(read_text(folder / "a.glb"));
  ASSERT_EQ(file.document["meshes"].size(), 2u);
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(same_bits(file.positions(i), posed_by_library(*scene, i, 5)));
    const asset::Asset& asset = scene->characters[scene->instances[i].character].asset;
    EXPECT_EQ(file.triangles(i), asset.triangles);
  }
}

TEST(PoseVerb, WritesOneRootNodeForEachInstanceInOrder) {
  const LimbsFolder folder;
  run_pelt(folder, {"pose", "scene.json", "--frame", "0", "-o", "a.glb"});
  const GlbFile file(read_text(folder / "a.glb"));
  const json& document = file.document;
  EXPECT_EQ(document["scenes"][0]["nodes"], json({0, 1}));
  EXPECT_EQ(document["nodes"], json::parse(R"([{"name": "one 0", "mesh": 0},
                                              {"name": "two 1", "mesh": 1}])"));
  for (std::size_t mesh = 0; mesh < 2; ++mesh) {
    const json& primitive = file.primitive(mesh);
    const auto component = [&](const json& accessor) {
      return document["accessors"][accessor.get<std::size_t>()]["componentType"];
    };
    EXPECT_EQ(component(primitive["indices"]), 5125);
    EXPECT_EQ(component(primitive["attributes"]["POSITION"]), 5126);
  }
}

}  // namespace
}  // namespace pelt::test
