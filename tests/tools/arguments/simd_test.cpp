/// --simd: other instructions, same answer and same work.

#include <pelt/config.hpp>

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

TEST(Simd, EveryTargetGivesTheSameAnswerWithTheSameWork) {
  const TestFolder folder;
  write_limbs(folder);
  std::vector<json> totals;
  for (const InstructionSet set : available_instruction_sets()) {
    const Ended run = run_pelt(
        folder, {"check", "scene.json", "--simd", name_of(set), "--jsonl", "-", "--pairs"});
    ASSERT_EQ(run.exit_code, 1) << run.err;
    totals.push_back(parse_check_file(run.out).totals);
    EXPECT_GT(totals.back()["totals"]["contacts"], 0);
    EXPECT_EQ(totals.back(), totals.front()) << name_of(set);
  }
  EXPECT_GE(totals.size(), 1u);
}

TEST(Simd, BenchNamesTheTargetItMeasured) {
  const TestFolder folder;
  write_limbs(folder);
  for (const InstructionSet set : available_instruction_sets()) {
    const Ended run = run_pelt(folder, {"bench", "scene.json", "--simd", name_of(set), "--methods",
                                        "on_demand", "--repeat", "1", "--json", "a.json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const json file = json::parse(read_text(folder / "a.json"));
    EXPECT_EQ(file["machine"]["instruction_set"], name_of(set));
    EXPECT_NE(run.out.find(std::string(", ") + name_of(set) + ", "), std::string::npos);
  }
}

}  // namespace
}  // namespace pelt::test
