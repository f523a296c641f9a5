/// A failed write is never reported as a success.

#include "tools/pelt/output/output_file.hpp"

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <sstream>

namespace pelt::test {
namespace {

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
