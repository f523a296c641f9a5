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
  std::vector<json> answers;
  for (const char* method : {"paper", "paper_eq2", "paper_eager", "paper_rigid", "brute"}) {
    const Ended run = run_pelt(folder, {"check", path, "--method", method, "--frames",
                                        GetParam().frames, "--jsonl", "-", "--pairs"});
    ASSERT_EQ(run.exit_code, 1) << method << run.err;
    const CheckFile file = parse_check_file(run.out);
    EXPECT_GT(file.totals["totals"]["contacts"], 0);
    answers.push_back({file.frames, file.totals["hash"]});
    EXPECT_EQ(answers.back(), answers.front()) << method;
  }
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
