/// `pelt bench --against`: its exit codes, and that nothing is measured if the output cannot be
/// written.

#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

Ended bench(const TestFolder& folder, const std::vector<std::string>& options) {
  std::vector<std::string> words = {"bench", "scene.json", "--repeat", "1",         "--frames",
                                    "4:7",   "--caches",   "hot",      "--queries", "all"};
  words.insert(words.end(), options.begin(), options.end());
  return run_pelt(folder, words);
}

/// Runs bench and returns the content of old.json.
json write_baseline(const TestFolder& folder) {
  write_limbs(folder);
  const Ended run = bench(folder, {"--json", "old.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(read_text(folder / "old.json"));
}

TEST(Against, ComparesWithWhatJsonWrote) {
  const TestFolder folder;
  write_baseline(folder);
  const Ended run = bench(folder, {"--against", "old.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("against old.json: "), std::string::npos);
  EXPECT_NE(run.out.find("of 3 ratios worse by more than 15 %"), std::string::npos) << run.out;
}

/// In the file, on demand takes a billionth of its real time.
TEST(Against, MarksWhatIsSlowerButDoesNotFail) {
  const TestFolder folder;
  json file = write_baseline(folder);
  for (json& method : file["scenes"][0]["methods"])
    if (method["method"] == "on_demand") method["mean_us"] = 1e-9 * double(method["mean_us"]);
  write_text(folder / "old.json", file.dump());
  const Ended run = bench(folder, {"--against", "old.json", "--margin", "1000"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("2 of 3 ratios worse by more than 1000 %"), std::string::npos) << run.out;
}

TEST(Against, ADifferentAnswerIsAFailure) {
  const TestFolder folder;
  json file = write_baseline(folder);
  for (json& method : file["scenes"][0]["methods"]) method["hash"] = "0123456789abcdef";
  write_text(folder / "old.json", file.dump());
  const Ended run = bench(folder, {"--against", "old.json", "--json", "new.json"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("different answers: hash 0123456789abcdef then"), std::string::npos);
  EXPECT_NE(run.err.find("1 answer different from old.json"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "new.json")) << "what was measured is not lost";
}

TEST(Against, KeepsItsFile) {
  const TestFolder folder;
  const json old = write_baseline(folder);
  const Ended run = bench(folder, {"--against", "old.json", "--json", "old.json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("name another file"), std::string::npos) << run.err;
  EXPECT_EQ(json::parse(read_text(folder / "old.json")), old);
}

TEST(Against, FileThatCannotBeWrittenIsRefusedBeforeAnyIsMeasured) {
  const TestFolder folder;
  write_limbs(folder);
  for (const char* path : {"no/folder/figures.json", "."}) {
    const Ended run = bench(folder, {"--json", path});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(std::string(path) + ": cannot be written"), std::string::npos);
  }
}

/// If measuring fails, no new file remains and no old file changes.
TEST(Against, FileIsAsItWasAfterAFailure) {
  const TestFolder folder;
  write_text(folder / "old.json", "precious");
  for (const char* path : {"old.json", "new.json"})
    EXPECT_EQ(run_pelt(folder, {"bench", "none.json", "--json", path}).exit_code, 2);
  EXPECT_EQ(read_text(folder / "old.json"), "precious");
  EXPECT_FALSE(std::filesystem::exists(folder / "new.json"));
}

}  // namespace
}  // namespace pelt::test
