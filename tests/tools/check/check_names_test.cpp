/// `pelt check --baseline` identifies contacts by names, in any order.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

/// Splits the single primitive of a limb into two of one material, so that two parts have the same
/// name.
std::vector<std::byte> limb_of_two_parts(std::uint32_t sides) {
  GltfBuilder limb = build_limb(sides);
  const json material = limb.add("materials", {{"name", "skin"}});
  json& primitives = limb.document["meshes"][0]["primitives"];
  primitives[0]["material"] = material;
  json& indices = limb.accessor(primitives[0]["indices"].get<std::size_t>());
  const std::size_t count = indices["count"], half = count / 6 * 3;
  json rest = indices;
  indices["count"] = half;
  rest["byteOffset"] = half * sizeof(std::uint32_t);
  rest["count"] = count - half;
  json second = primitives[0];
  second["indices"] = limb.add("accessors", rest);
  limb.document["meshes"][0]["primitives"].push_back(second);
  return limb.glb();
}

/// The verdict on `input`, with an earlier answer for `known` as the baseline.
json compare(const TestFolder& folder, const std::string& known, const std::string& input,
             const Words& options = {}) {
  std::vector<std::string> first = {"check", known, "--jsonl", "known.jsonl"};
  std::vector<std::string> second = {"check", input, "--baseline", "known.jsonl", "--jsonl", "-"};
  first.insert(first.end(), options.begin(), options.end());
  second.insert(second.end(), options.begin(), options.end());
  run_pelt(folder, 1, first);
  const Ended run = run_pelt(folder, second);
  EXPECT_LT(run.exit_code, 2) << run.err;
  const CheckFile file = parse_check_file(run.out);
  EXPECT_GT(file.totals["touches"].size(), 1u);
  EXPECT_EQ(file.totals["verdict"]["failed"], run.exit_code == 1);
  return file.totals["verdict"];
}

void expect_the_same(const json& verdict) {
  EXPECT_EQ(verdict["failed"], false) << verdict["worse"];
  EXPECT_EQ(verdict["worse"], json::array());
  EXPECT_EQ(verdict["gone"], json::array());
}

TEST(CheckNames, PartsOfOneNameAreOne) {
  const LimbsFolder folder;
  write_bytes(folder / "one.glb", limb_of_two_parts(24));
  write_bytes(folder / "two.glb", limb_of_two_parts(20));
  const json info = json::parse(run_pelt(folder, {"info", "one.glb", "--json"}).out);
  ASSERT_EQ(info["parts"].size(), 2u) << info;
  expect_the_same(compare(folder, "scene.json", "scene.json"));
  expect_the_same(compare(folder, "scene.json", "scene.json", {"--by", "part"}));
}

TEST(CheckNames, PartsMayChangeTheirOrder) {
  const StripFolder folder;
  std::filesystem::create_directory(folder / "later");
  GltfBuilder strip = strip_with_fan();
  strip.document["scenes"][0]["nodes"] = {1, 0};
  write_bytes(folder / "later/strip.glb", strip.glb());
  const json info = json::parse(run_pelt(folder, {"info", "later/strip.glb", "--json"}).out);
  ASSERT_EQ(info["parts"][0]["node"], "fan") << info;
  expect_the_same(compare(folder, "strip.glb", "later/strip.glb", {"--by", "part"}));
}

TEST(CheckNames, InstancesOfSeveralModelsMayChangeTheirOrder) {
  const LimbsFolder folder;
  json scene = json::parse(read_text(folder / "scene.json"));
  std::swap(scene["instances"][0], scene["instances"][1]);
  write_text(folder / "swapped.json", scene.dump());
  expect_the_same(compare(folder, "scene.json", "swapped.json"));
}

TEST(CheckNames, AnInstanceOfAnotherModelMayComeBefore) {
  const LimbsFolder folder;
  write_strip(folder, "strip.glb");
  json scene = json::parse(read_text(folder / "scene.json"));
  scene["models"]["strip"] = "strip.glb";
  json& instances = scene["instances"];
  const json strip = {{"model", "strip"}, {"translation", {0, 50, 0}}};
  instances.insert(instances.begin(), strip);
  write_text(folder / "more.json", scene.dump());
  const json verdict = compare(folder, "scene.json", "more.json");
  expect_the_same(verdict);
  EXPECT_EQ(verdict["notes"].size(), 1u);
}

TEST(CheckNames, AnotherNameIsNew) {
  const LimbsFolder folder;
  GltfBuilder limb = build_limb(24);
  limb.document["nodes"][1]["name"] = "renamed";
  write_bytes(folder / "renamed.glb", limb.glb());
  std::string text = read_text(folder / "scene.json");
  write_text(folder / "renamed.json", text.replace(text.find("one.glb"), 7, "renamed.glb"));
  const json verdict = compare(folder, "scene.json", "renamed.json");
  EXPECT_EQ(verdict["failed"], true);
  EXPECT_GT(verdict["gone"].size(), 0u);
}

}  // namespace
}  // namespace pelt::test
