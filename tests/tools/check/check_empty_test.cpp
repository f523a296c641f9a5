/// A check that compares nothing says so in every output, and fails unless this is allowed.

#include <pelt/version.hpp>

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <cstdlib>

namespace pelt::test {
namespace {

using Words = std::vector<std::string>;

/// Checks one strip of two parts with additional options.
Ended check_strip(const TestFolder& folder, const Words& options) {
  write_strip(folder, "strip.glb");
  Words words = {"check", "strip.glb", "--self", "no"};
  words.insert(words.end(), options.begin(), options.end());
  return run_pelt(folder, words);
}

TEST(CheckEmpty, IsNoSuccess) {
  const TestFolder folder;
  for (const Words& options : {Words{}, Words{"--fail-on", "never"},
                               Words{"--by", "part", "--exclude", "fan"}, Words{"--inside"}}) {
    const Ended run = check_strip(folder, options);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.out.find("contact    nothing was compared\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("so nothing can touch"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("contained"), std::string::npos) << run.out;
    EXPECT_NE(run.err.find("INPUT: nothing was compared"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("--allow-empty"), std::string::npos) << run.err;
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
  write_text(folder / "viewer.html", viewer_page(PELT_VERSION));
  ASSERT_EQ(setenv("PELT_VIEWER", (folder / "viewer.html").c_str(), 1), 0);
  const Ended run = check_strip(folder, {"--html", "report.html"});
  unsetenv("PELT_VIEWER");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(read_text(folder / "report.html").find("\"pairs_compared\":0"), std::string::npos);
}

TEST(CheckEmpty, CanBeAllowed) {
  const TestFolder folder;
  const Ended run = check_strip(folder, {"--allow-empty", "--jsonl", "answer.jsonl"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("contact    nothing was compared\n"), std::string::npos) << run.out;
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
