/// Real characters, where they are at hand: every method gives the same contacts, and there are
/// some.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

struct SharedScene {
  const char* name;
  const char* frames;  ///< some of them in contact
};

class SharedScenes : public ::testing::TestWithParam<SharedScene> {};

TEST_P(SharedScenes, HaveTheSameAnswerByEveryMethod) {
  const std::string path = std::string(PELT_SHARED_DIR) + "/scenes/" + GetParam().name;
  if (!std::filesystem::exists(PELT_SHARED_DIR)) GTEST_SKIP() << PELT_SHARED_DIR << " is not there";
  const TestFolder folder;
  expect_one_answer(folder, path, GetParam().frames);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedScenes,
                         ::testing::Values(SharedScene{"two_walkers.json", "117:118"},
                                           SharedScene{"walk_through.json", "50:51"},
                                           SharedScene{"duel.json", "12:13"},
                                           SharedScene{"zoo.json", "20:21"},
                                           SharedScene{"crowd50.json", "20:21"}),
                         [](const auto& scene) {
                           const std::string name = scene.param.name;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pelt::test
