#include "tools/pelt/output/line_output.hpp"

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

namespace fs = std::filesystem;
using tools::output::LineOutput;

TEST(LineOutput, LeavesTheFileAsItWasUntilItIsClosed) {
  const TestFolder folder;
  write_text(folder / "a.jsonl", "old\n");
  LineOutput lines;
  ASSERT_TRUE(lines.open(folder / "a.jsonl"));
  *lines.stream() << "new\n" << std::flush;
  EXPECT_EQ(read_text(folder / "a.jsonl"), "old\n");
  ASSERT_TRUE(lines.close());
  EXPECT_EQ(read_text(folder / "a.jsonl"), "new\n");
  EXPECT_FALSE(fs::exists(folder / "a.jsonl.partial"));
}

TEST(LineOutput, ThrowsAwayWhatIsNotClosed) {
  const TestFolder folder;
  write_text(folder / "a.jsonl", "old\n");
  {
    LineOutput lines;
    ASSERT_TRUE(lines.open(folder / "a.jsonl"));
    *lines.stream() << "new\n";
  }
  EXPECT_EQ(read_text(folder / "a.jsonl"), "old\n");
  EXPECT_FALSE(fs::exists(folder / "a.jsonl.partial"));
}

TEST(LineOutput, FollowsALinkAndKeepsPermissions) {
  const TestFolder folder;
  write_text(folder / "real.jsonl", "old\n");
  const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder / "real.jsonl", mode);
  fs::create_symlink("real.jsonl", folder / "link.jsonl");
  LineOutput lines;
  ASSERT_TRUE(lines.open(folder / "link.jsonl"));
  *lines.stream() << "new\n";
  ASSERT_TRUE(lines.close());
  EXPECT_TRUE(fs::is_symlink(folder / "link.jsonl"));
  EXPECT_EQ(read_text(folder / "real.jsonl"), "new\n");
  EXPECT_EQ(fs::status(folder / "real.jsonl").permissions(), mode);
}

TEST(LineOutput, WritesADeviceInPlace) {
  LineOutput lines;
  ASSERT_TRUE(lines.open("/dev/null"));
  *lines.stream() << "new\n";
  ASSERT_TRUE(lines.close());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_FALSE(fs::exists("/dev/null.partial"));
  LineOutput full;
  ASSERT_TRUE(full.open("/dev/full"));
  *full.stream() << "new\n";
  EXPECT_FALSE(full.close());
}

TEST(LineOutput, NamesWhatCannotBeWritten) {
  LineOutput lines;
  const auto opened = lines.open("no/such/folder/a.jsonl");
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find("no/such/folder/a.jsonl: cannot be written"),
            std::string::npos);
}

}  // namespace
}  // namespace pelt::test
