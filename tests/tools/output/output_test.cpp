/// A failed write is never reported as a success, and files are complete or unchanged.

#include "tools/pelt/output/output_file.hpp"

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <sstream>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;
using tools::output::OutputFile;

TEST(OutputFile, LeavesTheFileAsItWasUntilItIsClosed) {
  const TestFolder folder;
  write_text(folder / "a.jsonl", "old\n");
  OutputFile file;
  ASSERT_TRUE(file.open(folder / "a.jsonl"));
  *file.stream() << "new\n" << std::flush;
  EXPECT_EQ(read_text(folder / "a.jsonl"), "old\n");
  ASSERT_TRUE(file.close());
  EXPECT_EQ(read_text(folder / "a.jsonl"), "new\n");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"a.jsonl"});
}

TEST(OutputFile, ThrowsAwayWhatIsNotClosed) {
  const TestFolder folder;
  write_text(folder / "a.jsonl", "old\n");
  {
    OutputFile file;
    ASSERT_TRUE(file.open(folder / "a.jsonl"));
    *file.stream() << "new\n";
  }
  EXPECT_EQ(read_text(folder / "a.jsonl"), "old\n");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"a.jsonl"});
}

TEST(OutputFile, FollowsALinkAndKeepsPermissions) {
  const TestFolder folder;
  write_text(folder / "real.jsonl", "old\n");
  const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder / "real.jsonl", mode);
  fs::create_symlink("real.jsonl", folder / "link.jsonl");
  OutputFile file;
  ASSERT_TRUE(file.open(folder / "link.jsonl"));
  *file.stream() << "new\n";
  ASSERT_TRUE(file.close());
  EXPECT_TRUE(fs::is_symlink(folder / "link.jsonl"));
  EXPECT_EQ(read_text(folder / "real.jsonl"), "new\n");
  EXPECT_EQ(fs::status(folder / "real.jsonl").permissions(), mode);
}

TEST(OutputFile, WritesADeviceInPlace) {
  OutputFile file;
  ASSERT_TRUE(file.open("/dev/null"));
  *file.stream() << "new\n";
  ASSERT_TRUE(file.close());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  OutputFile full;
  ASSERT_TRUE(full.open("/dev/full"));
  *full.stream() << "new\n";
  EXPECT_FALSE(full.close());
}

TEST(OutputFile, NamesWhatCannotBeWritten) {
  OutputFile file;
  const auto opened = file.open("no/such/folder/a.jsonl");
  ASSERT_FALSE(opened);
  EXPECT_TRUE(contains(opened.error().message, "no/such/folder/a.jsonl: cannot be written"));
}

TEST(Output, FileThatCannotBeWrittenIsNamed) {
  const auto written = tools::output::write_file("no/such/folder/a.glb", {});
  ASSERT_FALSE(written);
  EXPECT_TRUE(contains(written.error().message, "no/such/folder/a.glb"));
}

TEST(Output, FileThatWasWrittenIsTold) {
  std::ostringstream words;
  for (const char* name : {"", tools::output::kStandardOutput, "a.glb"})
    tools::output::print_written(name, words);
  EXPECT_EQ(words.str(), "wrote a.glb\n");
}

Ended run_in_shell(const TestFolder& folder, const std::string& rest) {
  return run_program(folder.path(), {"sh", "-c", "'" PELT_COMMAND "' " + rest});
}

class LostOutput : public ::testing::TestWithParam<const char*> {};

TEST_P(LostOutput, IsAnError) {
  const LimbsFolder folder;
  write_strip(folder, "strip.glb");
  for (const std::string nowhere : {" > /dev/full", " >&-"}) {
    const Ended run = run_in_shell(folder, GetParam() + nowhere);
    EXPECT_EQ(run.exit_code, 2) << nowhere;
    EXPECT_TRUE(contains(run.err, "standard output: cannot be written"));
  }
}

INSTANTIATE_TEST_SUITE_P(Verbs, LostOutput,
                         ::testing::Values("check scene.json", "check strip.glb --allow-empty",
                                           "check strip.glb --fail-on never --jsonl -",
                                           "info strip.glb", "info strip.glb --json",
                                           "bench scene.json --frames 0:1 --repeat 1", "--help",
                                           "check --help", "--version"));

TEST(Output, FileDoesNotTakeThePlaceOfAClosedStream) {
  const StripFolder folder;
  const Ended whole = run_in_shell(folder, "check strip.glb --fail-on never --jsonl whole");
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  run_in_shell(folder, "check strip.glb --fail-on never --jsonl closed <&- >&- 2>&-");
  EXPECT_EQ(read_text(folder / "closed"), read_text(folder / "whole"));
}

}  // namespace
}  // namespace pelt::test
