/// Contact everywhere: several characters at one position with offset clips.

#include "tools/scene/every_method.hpp"
#include "tools/test_scenes.hpp"

#include <set>

namespace pelt::test {
namespace {

/// The content of the pile.json that scripts/pile-scene writes.
json write_pile(const TestFolder& folder, const std::vector<std::string>& arguments) {
  const Ended run =
      run_program(folder.path(), joined({PELT_PYTHON, PELT_SCRIPTS_DIR "/pile-scene"}, arguments));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  write_text(folder / "pile.json", run.out);
  return json::parse(run.out);
}

/// Expects the same contacts, at least one, from every method in one frame of the scene in this
/// file.
void expect_one_answer(const std::filesystem::path& path, std::uint32_t frame) {
  const Result<scenes::Scene> scene = scenes::load_scene(path);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(in_contact_by_every_method(*scene, frame, frame + 1), 1u);
}

TEST(Pile, OfCreaturesHasTheSameAnswerByEveryMethod) {
  expect_one_answer(std::string(PELT_SCENES_DIR) + "/pile.json", 7);
}

TEST(Pile, OfAnyCharacterIsWrittenByTheScript) {
  const LimbsFolder folder;
  const json scene = write_pile(folder, {"one.glb", "sway", "3"});
  ASSERT_EQ(scene["instances"].size(), 3u);
  std::set<json> starts;
  for (const json& instance : scene["instances"]) {
    EXPECT_FALSE(instance.contains("translation")) << "all stand in one place";
    starts.insert(instance["start"]);
  }
  EXPECT_EQ(starts.size(), 3u) << "in different postures";
  expect_one_answer(folder / "pile.json", 2);
}

TEST(Pile, OfHumansHasTheSameAnswerByEveryMethod) {
  const std::string human = std::string(PELT_SHARED_DIR) + "/models/human.glb";
  if (!std::filesystem::exists(human)) GTEST_SKIP() << human << " is not there";
  const TestFolder folder;
  write_pile(folder, {human, "walk", "3"});
  expect_one_answer(folder / "pile.json", 1);
}

}  // namespace
}  // namespace pelt::test
