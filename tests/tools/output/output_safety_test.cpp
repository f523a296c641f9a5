/// Every output file is either complete or unchanged, however the verb ends.

#include "tools/output/writers.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;

class Output : public ::testing::TestWithParam<Writer> {};

INSTANTIATE_TEST_SUITE_P(Verbs, Output, ::testing::ValuesIn(writers()), name_of_writer);

TEST_P(Output, ReplacesAnOldFileWhole) {
  const SafetyFolder folder;
  write_text(folder / "old", kOld);
  const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(folder / "old", mode);
  fs::create_symlink("old", folder / "link");
  const auto names = names_in(folder);
  run_pelt(folder, 0, with(GetParam().words, "link"));
  EXPECT_GT(fs::file_size(folder / "old"), 500u);
  EXPECT_FALSE(contains(read_text(folder / "old"), kOld));
  EXPECT_EQ(fs::status(folder / "old").permissions(), mode);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(names_in(folder), names);
}

TEST_P(Output, IsAsBeforeOnAFullDisk) {
  const SafetyFolder folder;
  write_text(folder / "old", kOld);
  const auto before = folder.contents();
  const Ended limited = run_in_shell(
      folder, "ulimit -f 1; { " + shell_command(with(GetParam().words, "old")) + "; } 2>&1");
  EXPECT_EQ(limited.exit_code, 2);
  EXPECT_TRUE(folder.contents() == before);
  const Ended full = run_pelt(folder, 2, with(GetParam().words, "/dev/full"));
  EXPECT_TRUE(contains(full.err, "/dev/full: cannot be written: No space left on device"));
}

TEST_P(Output, IsRefusedBeforeWorkWhereItCannotBeWritten) {
  const SafetyFolder folder;
  fs::create_directory(folder / "sub");
  const auto before = folder.contents();
  for (const std::string place : {"no/such/folder", "sub", "sub/"}) {
    const Ended run = run_pelt(folder, 2, with(GetParam().words, place));
    EXPECT_EQ(run.out, "") << place;
    EXPECT_TRUE(contains(run.err, place + ": cannot be written"));
  }
  EXPECT_TRUE(folder.contents() == before);
}

/// Whether the output has the command line, and so its own name.
bool names_its_output(const Writer& writer) {
  return writer.name == "check_html" || writer.name == "view";
}

/// The size of the output; lines that differ between runs have the same size.
std::size_t size_of(const Words& words, const SafetyFolder& folder) {
  run_pelt(folder, 0, with(words, "file"));
  return fs::file_size(folder / "file");
}

TEST_P(Output, GoesToStandardOutputPipesAndDevices) {
  const SafetyFolder folder;
  const std::size_t size = size_of(GetParam().words, folder);
  const bool repeats = !names_its_output(GetParam()) && GetParam().name != "bench";
  const std::string whole = read_text(folder / "file");
  const auto expect_whole = [&](const std::string& what, const std::string& text) {
    EXPECT_NEAR(static_cast<double>(text.size()), static_cast<double>(size), repeats ? 0 : 200)
        << what;
    if (repeats) {
      EXPECT_TRUE(text == whole) << what;
    }
  };
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    const Ended run = run_pelt(folder, 0, with(GetParam().words, name));
    expect_whole(name, run.out);
  }
  const std::string command = shell_command(with(GetParam().words, "/dev/stdout"));
  expect_whole("pipe", run_in_shell(folder, command + " 2>/dev/null | cat").out);
  const std::string words = shell_command(GetParam().words);
  expect_whole("descriptor", run_in_shell(folder, words + " /dev/fd/9 9>&1 >/dev/null").out);
  expect_whole("named pipe", run_in_shell(folder, "mkfifo pipe; " + words +
                                                      " pipe >/dev/null & cat pipe; wait; rm pipe")
                                 .out);
  run_pelt(folder, 0, with(GetParam().words, "/dev/null"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// Arguments that keep the verb busy until a signal ends it.
Words endless(Words words, const std::string& output) {
  words = with(std::move(words), output);
  for (std::string& word : words) {
    if (word == "scene.json") word = "long.json";
    if (word == "0:1") word = "0:1000000";
  }
  return words;
}

pid_t start(const SafetyFolder& folder, const Words& arguments) {
  const pid_t child = fork();
  if (child != 0) return child;
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const std::string command = shell_command(arguments);
  if (chdir(folder.path().c_str()) == 0)
    execlp("bash", "bash", "-c", ("exec " + command).c_str(), nullptr);
  _exit(127);
}

bool has_unfinished_file(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().starts_with(".pelt-")) return true;
  }
  return false;
}

/// Sends the signal once the verb has started to write. Returns the exit status.
int end_while_writing(pid_t child, const fs::path& folder, int signal) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  int status = 0;
  while (!has_unfinished_file(folder) && std::chrono::steady_clock::now() < deadline) {
    if (waitpid(child, &status, WNOHANG) == child) return status;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  kill(child, signal);
  waitpid(child, &status, 0);
  return status;
}

/// A short verb may end before the signal arrives, so this retries until the signal hits.
void expect_removed(const SafetyFolder& folder, const Words& words, const fs::path& written,
                    int signal) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    const int status = end_while_writing(start(folder, words), written, signal);
    EXPECT_FALSE(has_unfinished_file(written));
    if (!WIFSIGNALED(status)) continue;
    EXPECT_EQ(WTERMSIG(status), signal);
    return;
  }
  ADD_FAILURE() << "no run was hit by the signal";
}

TEST_P(Output, IsAsBeforeWhenASignalComes) {
  const SafetyFolder folder;
  std::string scene = read_text(folder / "scene.json");
  const std::string count = R"("count": 12)";
  ASSERT_TRUE(contains(scene, count));
  scene.replace(scene.find(count), count.size(), R"("count": 1000000)");
  write_text(folder / "long.json", scene);
  fs::create_directory(folder / "out");
  const Words& words = GetParam().words;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    write_text(folder / "out/old", kOld);
    expect_removed(folder, endless(words, "out/old"), folder / "out", signal);
    const bool is_short = words[0] == "pose" || words[0] == "prepare" || words[0] == "view";
    if (!is_short) {
      EXPECT_EQ(read_text(folder / "out/old"), kOld);
    }
    EXPECT_EQ(names_in_path(folder / "out"), std::set<std::string>{"old"});
  }
}

TEST_P(Output, OfTwoRunsAtOnceIsThatOfOne) {
  const SafetyFolder folder;
  const std::size_t size = size_of(GetParam().words, folder);
  const auto names = names_in(folder);
  const Words words = with(GetParam().words, "file");
  for (int i = 0; i < 5; ++i) {
    const pid_t one = start(folder, words), two = start(folder, words);
    int status = 0;
    for (const pid_t child : {one, two}) {
      waitpid(child, &status, 0);
      EXPECT_EQ(status, 0);
    }
    EXPECT_NEAR(static_cast<double>(fs::file_size(folder / "file")), static_cast<double>(size),
                GetParam().name == "bench" || names_its_output(GetParam()) ? 200 : 0);
  }
  EXPECT_EQ(names_in(folder), names);
}

/// Two processes write different answers to one path; a mixture would equal neither.
TEST(Outputs, OfTwoRunsAtOnceAreNeverMixed) {
  const SafetyFolder folder;
  const Words check = {"check", "scene.json", "--fail-on", "never"};
  Words few = check, many = check;
  few.insert(few.end(), {"--frames", "0:1", "--jsonl"});
  many.insert(many.end(), {"--pairs", "--jsonl"});
  run_pelt(folder, 0, with(few, "few"));
  run_pelt(folder, 0, with(many, "many"));
  const std::string a = read_text(folder / "few"), b = read_text(folder / "many");
  ASSERT_NE(a.size(), b.size());
  for (int i = 0; i < 10; ++i) {
    const pid_t one = start(folder, with(few, "file")), two = start(folder, with(many, "file"));
    waitpid(one, nullptr, 0);
    waitpid(two, nullptr, 0);
    const std::string got = read_text(folder / "file");
    EXPECT_TRUE(got == a || got == b);
  }
}

TEST(Outputs, KeepAReadOnlyFile) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may write everything";
  const SafetyFolder folder;
  write_text(folder / "old", kOld);
  fs::permissions(folder / "old", fs::perms::owner_read);
  run_pelt(folder, 2, {"bounds", "scene.json", "--jsonl", "old"});
  EXPECT_EQ(read_text(folder / "old"), kOld);
}

TEST(Outputs, OfADemoAreAsBeforeOnAFullDiskOrASignal) {
  const SafetyFolder folder;
  run_pelt(folder, 0, {"demo", "--no-picture"});
  for (const char* name : {"azure.glb", "contacts.jsonl"})
    write_text(folder / ("pelt-demo/" + std::string(name)), kOld);
  const Ended limited = run_in_shell(folder, "ulimit -f 1; " + shell_command({"demo"}));
  EXPECT_EQ(limited.exit_code, 2);
  EXPECT_EQ(read_text(folder / "pelt-demo/azure.glb"), kOld);
  EXPECT_EQ(read_text(folder / "pelt-demo/contacts.jsonl"), kOld);
  EXPECT_FALSE(has_unfinished_file(folder / "pelt-demo"));
  expect_removed(folder, {"demo", "--no-picture"}, folder / "pelt-demo", SIGTERM);
}

}  // namespace
}  // namespace pelt::test
