/// A check that compares nothing says so in every output, and fails unless this is allowed.

#include <pelt/version.hpp>

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <cstdlib>

namespace pelt::test {
namespace {

/// Checks one strip of two parts with additional options.
Ended check_strip(const TestFolder& folder, const Words& options) {
  write_strip(folder, "strip.glb");
  return run_pelt(folder, joined({"check", "strip.glb", "--self", "no"}, options));
}

TEST(CheckEmpty, IsNoSuccess) {
  const TestFolder folder;
  for (const Words& options : {Words{}, Words{"--fail-on", "never"},
                               Words{"--by", "part", "--exclude", "fan"}, Words{"--inside"}}) {
    const Ended run = check_strip(folder, options);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.out, "contact    nothing was compared\n"));
    EXPECT_TRUE(contains(run.out, "so nothing can touch"));
    EXPECT_FALSE(contains(run.out, "contained"));
    EXPECT_TRUE(contains(run.err, "INPUT: nothing was compared"));
    EXPECT_TRUE(contains(run.err, "--allow-empty"));
  }
}

TEST(CheckEmpty, IsTheVerdictInJson) {
  const TestFolder folder;
  const Ended run = check_strip(folder, {"--jsonl", "-"});
  EXPECT_EQ(run.exit_code, 2);
  const CheckFile file = parse_check_file(run.out);
  EXPECT_EQ(file.totals["verdict"]["pairs_compared"], 0);
  EXPECT_EQ(file.totals["verdict"]["failed"], true);
}

TEST(CheckEmpty, IsToldByTheReport) {
  const TestFolder folder;
  const ViewerPage viewer(folder);
  const Ended run = check_strip(folder, {"--html", "report.html"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(read_text(folder / "report.html"), "\"pairs_compared\":0"));
}

TEST(CheckEmpty, CanBeAllowed) {
  const TestFolder folder;
  const Ended run = check_strip(folder, {"--allow-empty", "--jsonl", "answer.jsonl"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "contact    nothing was compared\n"));
  const CheckFile file = parse_check_file(read_text(folder / "answer.jsonl"));
  EXPECT_EQ(file.totals["verdict"]["pairs_compared"], 0);
  EXPECT_EQ(file.totals["verdict"]["failed"], false);
}

TEST(CheckEmpty, IsNotACheckOfParts) {
  const TestFolder folder;
  const Ended run = check_strip(folder, {"--by", "part", "--jsonl", "-"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const CheckFile file = parse_check_file(run.out);
  EXPECT_EQ(file.totals["verdict"]["pairs_compared"], 1);
  const Ended four = run_pelt(folder, {"check", "strip.glb", "strip.glb", "--by", "part",
                                       "--fail-on", "never", "--jsonl", "-"});
  EXPECT_EQ(parse_check_file(four.out).totals["verdict"]["pairs_compared"], 6);
}

}  // namespace
}  // namespace pelt::test
