/// The answers on the benchmark's scenes, whose characters are generated: the same bits from every
/// compiler, build type and instruction set. A hash here changes only with the scenes, the
/// characters or the definition of a posed vertex.

#include "tools/answer.hpp"

namespace pelt::test {
namespace {

struct Golden {
  const char* scene;
  const char* frames;
  int contacts;
  const char* hash;
};

class GoldenHash : public ::testing::TestWithParam<Golden> {};

TEST_P(GoldenHash, IsTheSameEverywhere) {
  const TestFolder folder;
  const std::string path = std::string(PELT_SCENES_DIR) + "/" + GetParam().scene + ".json";
  const Ended run =
      run_pelt(folder, {"check", path, "--frames", GetParam().frames, "--jsonl", "-"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const CheckFile file = parse_check_file(run.out);
  EXPECT_EQ(file.totals["totals"]["contacts"], GetParam().contacts);
  EXPECT_EQ(file.totals["hash"], GetParam().hash);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, GoldenHash,
    ::testing::Values(Golden{"approaching", "110:120", 365, "8ed0d7896ec497d0"},
                      Golden{"passing_through", "30:90:20", 1728, "8544fb62786a6f33"},
                      Golden{"crowd", "10:11", 5382, "b446516afc6427fc"},
                      Golden{"pile", "0:30:15", 26471, "2e9d2a0a5ac3029e"}),
    [](const auto& golden) { return std::string(golden.param.scene); });

}  // namespace
}  // namespace pelt::test
