/// Contact everywhere: several characters in one place, their clips offset.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

TEST(Pile, OfCreaturesHasTheSameAnswerByEveryMethod) {
  const TestFolder folder;
  expect_one_answer(folder, std::string(PELT_SCENES_DIR) + "/pile.json", "7:8");
}

TEST(Pile, OfHumansHasTheSameAnswerByEveryMethod) {
  const std::string human = std::string(PELT_SHARED_DIR) + "/models/human.glb";
  if (!std::filesystem::exists(human)) GTEST_SKIP() << human << " is not there";
  const TestFolder folder;
  std::string instances;
  for (const double start : {0.0, 0.3, 0.7}) {
    instances += (instances.empty() ? "" : ",") + std::string(R"({"model": "human", )") +
                 R"("clip": "walk", "start": )" + std::to_string(start) + "}";
  }
  write_text(folder / "pile.json", R"({"models": {"human": ")" + human +
                                       R"("}, "frames": {"count": 2, "fps": 30}, "instances": [)" +
                                       instances + "]}");
  expect_one_answer(folder, "pile.json", "1:2");
}

}  // namespace
}  // namespace pelt::test
