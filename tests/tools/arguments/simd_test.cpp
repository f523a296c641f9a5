/// --simd: other instructions, same answer and same work.

#include <pelt/config.hpp>

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

TEST(Simd, EveryTargetGivesTheSameAnswerWithTheSameWork) {
  const LimbsFolder folder;
  std::vector<json> totals;
  for (const InstructionSet set : available_instruction_sets()) {
    totals.push_back(
        answer_of(folder, 1, {"check", "scene.json", "--simd", name_of(set), "--pairs"}).totals);
    EXPECT_GT(totals.back()["totals"]["contacts"], 0);
    EXPECT_EQ(totals.back(), totals.front()) << name_of(set);
  }
  EXPECT_GE(totals.size(), 1u);
}

TEST(Simd, BenchNamesTheTargetItMeasured) {
  const LimbsFolder folder;
  for (const InstructionSet set : available_instruction_sets()) {
    const Ended run = run_pelt(folder, 0,
                               {"bench", "scene.json", "--simd", name_of(set), "--methods",
                                "on_demand", "--repeat", "1", "--json", "a.json"});
    const json file = json::parse(read_text(folder / "a.json"));
    EXPECT_EQ(file["machine"]["instruction_set"], name_of(set));
    EXPECT_TRUE(contains(run.out, std::string(", ") + name_of(set) + ", "));
  }
}

}  // namespace
}  // namespace pelt::test
