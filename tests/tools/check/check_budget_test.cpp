/// `pelt check --budget`: contacts under a limit of the work, and what it leaves undecided.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

class CheckBudget : public ::testing::Test {
 protected:
  void SetUp() override { write_limbs(folder_); }

  Ended check(const Words& options) {
    return run_pelt(folder_, joined({"check", "scene.json", "--jsonl", "answer.jsonl"}, options));
  }

  CheckFile answer() { return parse_check_file(read_text(folder_ / "answer.jsonl")); }

  void expect_refused(const Words& options, const std::string& message) {
    const Ended run = check(options);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.err, message));
  }

  TestFolder folder_;
};

TEST_F(CheckBudget, ALargeBudgetGivesTheWholeAnswer) {
  check({});
  const CheckFile expected = answer();
  const Ended run = check({"--budget", "4000000000"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.out, "unknown    nothing: the budget sufficed for all frames\n"));
  const CheckFile found = answer();
  EXPECT_EQ(found.totals["hash"], expected.totals["hash"]);
  EXPECT_EQ(found.totals["totals"]["contacts"], expected.totals["totals"]["contacts"]);
  EXPECT_EQ(found.totals["totals"]["unknown"]["frames"], 0);
  EXPECT_EQ(found.header["options"]["budget"], 4000000000u);
}

TEST_F(CheckBudget, ASmallBudgetSaysWhatIsUndecided) {
  check({});
  const CheckFile expected = answer();
  const Ended run = check({"--budget", "500"});
  const CheckFile found = answer();
  const auto& unknown = found.totals["totals"]["unknown"];
  EXPECT_GT(unknown["frames"], 2);
  EXPECT_GT(unknown["pairs"], 10);
  EXPECT_GT(unknown["resolution"], 0);
  EXPECT_EQ(found.totals["hash"], nullptr);
  EXPECT_LT(found.totals["totals"]["contacts"], expected.totals["totals"]["contacts"]);
  EXPECT_TRUE(contains(run.out, "frames: at most "));
  ASSERT_EQ(found.frames.size(), expected.frames.size());
  int undecided = 0;
  for (std::size_t i = 0; i < found.frames.size(); ++i) {
    const auto& frame = found.frames[i];
    if (frame["unknown"].empty()) {
      EXPECT_EQ(frame["contacts"], expected.frames[i]["contacts"]);
      continue;
    }
    ++undecided;
    const auto& pair = frame["unknown"][0];
    EXPECT_EQ(pair["a"], 0);
    EXPECT_EQ(pair["b"], 1);
    EXPECT_EQ(pair["verdict"], frame["contacts"] > 0 ? "touching" : "unknown");
    EXPECT_GT(pair["pairs"], 0);
  }
  EXPECT_EQ(unknown["frames"], undecided);
}

TEST_F(CheckBudget, CanFailOnUnknownPairs) {
  EXPECT_EQ(check({"--budget", "1", "--frames", "5:6"}).exit_code, 0);
  EXPECT_EQ(check({"--budget", "1", "--frames", "5:6", "--fail-on", "unknown"}).exit_code, 1);
  EXPECT_EQ(check({"--budget", "1", "--frames", "0:1", "--fail-on", "unknown"}).exit_code, 0);
}

TEST_F(CheckBudget, RefusesWhatNeedsAllContacts) {
  expect_refused({"--budget", "5", "--clearance", "1"},
                 "--budget: cannot be combined with --clear");
  expect_refused({"--budget", "5", "--inside"}, "--budget: cannot be combined with --inside");
  expect_refused({"--budget", "5", "--first"}, "--budget: cannot be combined with --first");
  expect_refused({"--budget", "5", "--self"}, "--self: cannot be combined with --budget");
  expect_refused({"--budget", "5", "--method", "brute"}, "--budget: requires the method on_demand");
  expect_refused({"--budget", "0"}, "--budget");
  expect_refused({"--fail-on", "unknown"}, "--fail-on: unknown requires a limit of the work");
}

}  // namespace
}  // namespace pelt::test
