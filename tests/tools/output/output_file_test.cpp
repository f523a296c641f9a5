#include "tools/pelt/output/output_file.hpp"

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

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

}  // namespace
}  // namespace pelt::test
