#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

TEST(Info, PrintsTheContentsOfAModel) {
  const StripFolder folder;
  const Ended run = run_pelt(folder, 0, {"info", "strip.glb", "--json"});
  json info = json::parse(run.out);
  EXPECT_EQ(info["hash"].get<std::string>().size(), 16u);
  info.erase("hash");
  EXPECT_GT(info["prepared_bytes"], 12 * 12 + 8 * 6);
  info.erase("prepared_bytes");
  EXPECT_EQ(info, json::parse(R"({
    "format": "pelt-info", "version": 1, "model": "strip.glb",
    "vertices": 12, "distinct_positions": 12, "triangles": 8, "degenerate_triangles": 0,
    "influences_per_vertex": 2, "renormalised_vertices": 0, "merged_influences": 0,
    "joints": ["lower", "upper", "fan"],
    "morph_targets": [],
    "clips": [{"name": "bend", "duration": 1.0}, {"name": "", "duration": 1.0}],
    "parts": [
      {"name": "paper", "node": "paper", "mesh": "sheet", "material": "", "first_triangle": 0, "triangles": 6,
       "skinned": true},
      {"name": "fan", "node": "fan", "mesh": "", "material": "", "first_triangle": 6, "triangles": 2,
       "skinned": false}],
    "warnings": []})"));
}

TEST(Info, CountsWhatTheBuildMended) {
  const TestFolder folder;
  GltfBuilder builder = strip_with_fan();
  builder.set_value(3, 0, 1.5f);             // weights of vertex 0 sum to 1.5
  builder.set_value(2, 4, std::uint8_t{1});  // vertex 1 names joint 1 twice
  builder.set_value(3, 4, 0.5f);
  builder.set_value(3, 5, 0.5f);
  builder.set_value(0, 1, std::uint16_t{0});  // triangle 0 has vertex 0 twice
  write_bytes(folder / "odd.glb", builder.glb());
  run_pelt(folder, 2, {"info", "odd.glb"});
  const Ended run = run_pelt(folder, 0, {"info", "odd.glb", "--json", "--renormalise"});
  const json info = json::parse(run.out);
  EXPECT_EQ(info["renormalised_vertices"], 1);
  EXPECT_EQ(info["merged_influences"], 1);
  EXPECT_EQ(info["degenerate_triangles"], 1);
}

TEST(Info, SpeaksToPeopleToo) {
  const StripFolder folder;
  const Ended run = run_pelt(folder, 0, {"info", "strip.glb"});
  for (const char* words :
       {"12, at 12 distinct positions", "up to 2", "1.000 s  bend", "\"\" (unnamed)",
        "  lower,  upper,  fan\n", "6 triangles  paper  (mesh \"sheet\"", "not skinned)"}) {
    EXPECT_TRUE(contains(run.out, words));
  }
}

}  // namespace
}  // namespace pelt::test
