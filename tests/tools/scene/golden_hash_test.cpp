/// The answers for the benchmark scenes, whose characters are generated, and for real characters if
/// they are available. The bits do not depend on the compiler, build type or instruction set. A
/// hash here changes only if the scenes, the characters or the definition of a posed vertex change.

#include <pelt/config.hpp>

#include "tools/answer.hpp"

namespace pelt::test {
namespace {

struct Golden {
  const char* folder;
  const char* scene;
  const char* frames;
  int contacts;
  const char* hash;
};

class GoldenHash : public ::testing::TestWithParam<Golden> {};

void expect_golden(Words arguments) {
  SCOPED_TRACE(arguments.back());
  const TestFolder folder;
  const Golden& golden = GoldenHash::GetParam();
  const std::string path = std::string(golden.folder) + "/" + golden.scene + ".json";
  arguments.insert(arguments.begin(), {"check", path, "--frames", golden.frames, "--jsonl", "-"});
  const Ended run = run_pelt(folder, 1, arguments);
  const CheckFile file = parse_check_file(run.out);
  EXPECT_EQ(file.totals["totals"]["contacts"], golden.contacts);
  EXPECT_EQ(file.totals["hash"], golden.hash);
}

TEST_P(GoldenHash, IsTheSameOnEveryTarget) {
  if (!std::filesystem::exists(GetParam().folder))
    GTEST_SKIP() << GetParam().folder << " is not there";
  for (const InstructionSet set : available_instruction_sets())
    expect_golden({"--simd", name_of(set)});
}

std::string scene_name(const ::testing::TestParamInfo<Golden>& golden) {
  return golden.param.scene;
}

constexpr const char* kGenerated = PELT_SCENES_DIR;
constexpr const char* kShared = PELT_SHARED_DIR "/scenes";

INSTANTIATE_TEST_SUITE_P(
    Scenes, GoldenHash,
    ::testing::Values(Golden{kGenerated, "approaching", "110:120", 365, "8ed0d7896ec497d0"},
                      Golden{kGenerated, "passing_through", "30:90:20", 1728, "8544fb62786a6f33"},
                      Golden{kGenerated, "crowd", "10:11", 5382, "b446516afc6427fc"},
                      Golden{kGenerated, "pile", "0:30:15", 26471, "2e9d2a0a5ac3029e"},
                      Golden{kShared, "two_walkers", "0:120", 1279, "51d83e213bbe2c15"},
                      Golden{kShared, "walk_through", "0:120", 36823, "a8875e78bb4a190c"},
                      Golden{kShared, "duel", "0:30", 45808, "a4e64c2ef01e7395"},
                      Golden{kShared, "zoo", "0:30", 48619, "c16684a34bccbd02"},
                      Golden{kShared, "crowd50", "0:30", 152545, "7c803b38920623de"}),
    scene_name);

}  // namespace
}  // namespace pelt::test
