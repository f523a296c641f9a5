/// No output overwrites an input or another output, and every output file is either complete or
/// unchanged, however the verb ends.

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <pelt/version.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::string kOld = "what was there before\n";

/// A verb with one output, whose name is the last argument.
struct Writer {
  std::string name;
  Words words;
  bool reads_scene = true;  ///< otherwise a.gltf
};

void PrintTo(const Writer& writer, std::ostream* out) { *out << writer.name; }

/// All outputs of all verbs, except `demo`, which writes a folder and has tests of its own.
std::vector<Writer> writers() {
  return {{"check_jsonl", {"check", "scene.json", "--fail-on", "never", "--jsonl"}},
          {"check_glb", {"check", "scene.json", "--fail-on", "never", "--glb"}},
          {"check_html", {"check", "scene.json", "--fail-on", "never", "--html"}},
          {"bounds", {"bounds", "scene.json", "--jsonl"}},
          {"distance", {"distance", "scene.json", "--jsonl"}},
          {"closest", {"distance", "scene.json", "--from", "0,0,0", "--jsonl"}},
          {"ray", {"ray", "scene.json", "--from", "0,0.5,-3", "--to", "0,0.5,3", "--jsonl"}},
          {"region", {"region", "scene.json", "--sphere", "0,0,0,1", "--jsonl"}},
          {"pose", {"pose", "scene.json", "--frame", "3", "-o"}},
          {"prepare", {"prepare", "a.gltf", "-o"}, false},
          {"bench",
           {"bench", "scene.json", "--frames", "0:1", "--repeat", "1", "--methods", "on_demand",
            "--json"}}};
}

/// A folder with a scene of a.gltf, the buffer a.bin and the image that a.gltf names, and the
/// viewer's page.
class SafetyFolder {
 public:
  SafetyFolder() {
    GltfBuilder builder = build_limb(12);
    builder.document["buffers"] = {{{"byteLength", builder.binary.size()}, {"uri", "a.bin"}}};
    builder.document["images"] = {{{"uri", "skin%20a.png"}}};
    write_text(folder_ / "a.gltf", builder.document.dump());
    write_bytes(folder_ / "a.bin", builder.binary);
    write_text(folder_ / "skin a.png", "picture");
    std::string scene = kLimbsScene;
    for (const std::string model : {"one.glb", "two.glb"})
      scene.replace(scene.find(model), model.size(), "a.gltf");
    write_text(folder_ / "scene.json", scene);
    write_text(folder_ / "viewer.html", viewer_page(PELT_VERSION));
    EXPECT_EQ(setenv("PELT_VIEWER", (folder_ / "viewer.html").c_str(), 1), 0);
  }
  ~SafetyFolder() { unsetenv("PELT_VIEWER"); }

  const TestFolder& get() const { return folder_; }
  std::string operator/(const std::string& name) const { return folder_ / name; }

  /// Names and contents of the files; follows links.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const std::string& name : names_in(folder_)) {
      if (fs::is_regular_file(folder_ / name)) all[name] = read_text(folder_ / name);
    }
    return all;
  }

 private:
  TestFolder folder_;
};

Words with(Words words, const std::string& last) {
  words.push_back(last);
  return words;
}

std::string shell_command(const Words& words) {
  std::string command = "'" PELT_COMMAND "'";
  for (const std::string& word : words) command.append(" '").append(word).append("'");
  return command;
}

Ended run_in_shell(const SafetyFolder& folder, const std::string& script) {
  return run_program(folder.get().path(), {"bash", "-c", script});
}

class Output : public ::testing::TestWithParam<Writer> {};

std::string name_of(const ::testing::TestParamInfo<Writer>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Verbs, Output, ::testing::ValuesIn(writers()), name_of);

TEST_P(Output, IsNoInput) {
  const SafetyFolder folder;
  fs::create_directory(folder / "sub");
  fs::create_symlink("a.gltf", folder / "symbolic.gltf");
  fs::create_symlink("symbolic.gltf", folder / "twice.gltf");
  fs::create_directory_symlink(".", folder / "here");
  fs::create_hard_link(folder / "a.gltf", folder / "hard.gltf");
  Words inputs = {"a.gltf",     "./a.gltf",    "sub/../a.gltf", "symbolic.gltf",
                  "twice.gltf", "here/a.gltf", "hard.gltf",     "A.GLTF",
                  "a.bin",      "skin a.png",  "Skin A.PNG",    folder / "a.gltf"};
  if (GetParam().reads_scene) inputs.push_back("scene.json");
  if (GetParam().name.starts_with("check")) inputs.push_back("viewer.html");
  const auto before = folder.contents();
  for (const std::string& input : inputs) {
    const Ended run = run_pelt(folder.get(), with(GetParam().words, input));
    EXPECT_EQ(run.exit_code, 2) << input << run.out;
    EXPECT_EQ(run.out, "") << input;
    EXPECT_NE(run.err.find(input + " is "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(": name another file"), std::string::npos) << run.err;
    EXPECT_TRUE(folder.contents() == before) << input;
  }
}

/// Scripts of the shell in which "..." is the command, and "a.gltf" an input.
TEST_P(Output, IsNoInputThroughADescriptor) {
  const SafetyFolder folder;
  const auto before = folder.contents();
  const std::string words = shell_command(GetParam().words);
  std::vector<std::pair<std::string, std::string>> scripts = {
      {" /dev/fd/9 9<>a.gltf", ": /dev/fd/9 is the model a.gltf"},
      {" /dev/fd/9 9>>a.bin", ": /dev/fd/9 is a file of the model a.gltf"},
      {" /proc/self/fd/9 9>>a.gltf", ": /proc/self/fd/9 is the model a.gltf"},
      {" - >>a.gltf", "standard output: goes to the model a.gltf"},
      {" - 1<>a.bin", "standard output: goes to a file of the model a.gltf"},
      {" new >>a.gltf", "standard output: goes to the model a.gltf"},
      {" /dev/fd/8 9<>a.gltf 8>&9", ": /dev/fd/8 is the model a.gltf"}};
  if (GetParam().reads_scene)
    scripts.emplace_back(" - >>scene.json", "standard output: goes to the scene scene.json");
  for (const auto& [script, message] : scripts) {
    const Ended run = run_in_shell(folder, words + script);
    EXPECT_EQ(run.exit_code, 2) << script;
    EXPECT_EQ(run.out, "") << script;
    EXPECT_NE(run.err.find(message), std::string::npos) << script << run.err;
    EXPECT_TRUE(folder.contents() == before) << script;
  }
}

TEST_P(Output, ReplacesAnOldFileWhole) {
  const SafetyFolder folder;
  write_text(folder / "old", kOld);
  const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(folder / "old", mode);
  fs::create_symlink("old", folder / "link");
  const auto names = names_in(folder.get());
  const Ended run = run_pelt(folder.get(), with(GetParam().words, "link"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GT(fs::file_size(folder / "old"), 500u);
  EXPECT_EQ(read_text(folder / "old").find(kOld), std::string::npos);
  EXPECT_EQ(fs::status(folder / "old").permissions(), mode);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(names_in(folder.get()), names);
}

TEST_P(Output, IsAsBeforeOnAFullDisk) {
  const SafetyFolder folder;
  write_text(folder / "old", kOld);
  const auto before = folder.contents();
  const Ended limited = run_in_shell(
      folder, "ulimit -f 1; { " + shell_command(with(GetParam().words, "old")) + "; } 2>&1");
  EXPECT_EQ(limited.exit_code, 2);
  EXPECT_TRUE(folder.contents() == before);
  const Ended full = run_pelt(folder.get(), with(GetParam().words, "/dev/full"));
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_NE(full.err.find("/dev/full: cannot be written: No space left on device"),
            std::string::npos)
      << full.err;
}

TEST_P(Output, IsRefusedBeforeWorkWhereItCannotBeWritten) {
  const SafetyFolder folder;
  fs::create_directory(folder / "sub");
  const auto before = folder.contents();
  for (const std::string place : {"no/such/folder", "sub", "sub/"}) {
    const Ended run = run_pelt(folder.get(), with(GetParam().words, place));
    EXPECT_EQ(run.exit_code, 2) << place;
    EXPECT_EQ(run.out, "") << place;
    EXPECT_NE(run.err.find(place + ": cannot be written"), std::string::npos) << run.err;
  }
  EXPECT_TRUE(folder.contents() == before);
}

/// The size of the output; lines that differ between runs have the same size.
std::size_t size_of(const Words& words, const SafetyFolder& folder) {
  EXPECT_EQ(run_pelt(folder.get(), with(words, "file")).exit_code, 0);
  return fs::file_size(folder / "file");
}

TEST_P(Output, GoesToStandardOutputPipesAndDevices) {
  const SafetyFolder folder;
  const std::size_t size = size_of(GetParam().words, folder);
  const bool repeats = GetParam().name != "bench" && GetParam().name != "check_html";
  const std::string whole = read_text(folder / "file");
  const auto expect_whole = [&](const std::string& what, const std::string& text) {
    EXPECT_NEAR(static_cast<double>(text.size()), static_cast<double>(size), repeats ? 0 : 200)
        << what;
    if (repeats) {
      EXPECT_TRUE(text == whole) << what;
    }
  };
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    const Ended run = run_pelt(folder.get(), with(GetParam().words, name));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    expect_whole(name, run.out);
  }
  const std::string command = shell_command(with(GetParam().words, "/dev/stdout"));
  expect_whole("pipe", run_in_shell(folder, command + " 2>/dev/null | cat").out);
  const std::string words = shell_command(GetParam().words);
  expect_whole("descriptor", run_in_shell(folder, words + " /dev/fd/9 9>&1 >/dev/null").out);
  expect_whole("named pipe", run_in_shell(folder, "mkfifo pipe; " + words +
                                                      " pipe >/dev/null & cat pipe; wait; rm pipe")
                                 .out);
  EXPECT_EQ(run_pelt(folder.get(), with(GetParam().words, "/dev/null")).exit_code, 0);
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
  if (chdir(folder.get().path().c_str()) == 0)
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
  ASSERT_NE(scene.find(count), std::string::npos) << scene;
  scene.replace(scene.find(count), count.size(), R"("count": 1000000)");
  write_text(folder / "long.json", scene);
  fs::create_directory(folder / "out");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    write_text(folder / "out/old", kOld);
    expect_removed(folder, endless(GetParam().words, "out/old"), folder / "out", signal);
    if (GetParam().name != "pose" && GetParam().name != "prepare") {
      EXPECT_EQ(read_text(folder / "out/old"), kOld);
    }
    EXPECT_EQ(names_in_path(folder / "out"), std::set<std::string>{"old"});
  }
}

TEST_P(Output, OfTwoRunsAtOnceIsThatOfOne) {
  const SafetyFolder folder;
  const std::size_t size = size_of(GetParam().words, folder);
  const auto names = names_in(folder.get());
  const Words words = with(GetParam().words, "file");
  for (int i = 0; i < 5; ++i) {
    const pid_t one = start(folder, words), two = start(folder, words);
    int status = 0;
    for (const pid_t child : {one, two}) {
      waitpid(child, &status, 0);
      EXPECT_EQ(status, 0);
    }
    EXPECT_NEAR(static_cast<double>(fs::file_size(folder / "file")), static_cast<double>(size),
                GetParam().name == "bench" || GetParam().name == "check_html" ? 200 : 0);
  }
  EXPECT_EQ(names_in(folder.get()), names);
}

/// Two processes write different answers to one path; a mixture would equal neither.
TEST(Outputs, OfTwoRunsAtOnceAreNeverMixed) {
  const SafetyFolder folder;
  const Words check = {"check", "scene.json", "--fail-on", "never"};
  Words few = check, many = check;
  few.insert(few.end(), {"--frames", "0:1", "--jsonl"});
  many.insert(many.end(), {"--pairs", "--jsonl"});
  ASSERT_EQ(run_pelt(folder.get(), with(few, "few")).exit_code, 0);
  ASSERT_EQ(run_pelt(folder.get(), with(many, "many")).exit_code, 0);
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

TEST(Outputs, AreNotEachOther) {
  const SafetyFolder folder;
  write_text(folder / "b", kOld);
  fs::create_symlink("new", folder / "dangling");
  fs::create_symlink("b", folder / "symbolic");
  fs::create_hard_link(folder / "b", folder / "hard");
  fs::create_directory_symlink(".", folder / "here");
  const auto before = folder.contents();
  const std::vector<std::pair<std::string, std::string>> same = {
      {"x", "x"},        {"x", "./x"},  {"x", "X"}, {"x", "here/x"},     {"new", "dangling"},
      {"b", "symbolic"}, {"b", "hard"}, {"-", "-"}, {"-", "/dev/stdout"}};
  for (const auto& [a, b] : same) {
    for (const std::string other : {"--glb", "--html"}) {
      const Ended run = run_pelt(folder.get(), {"check", "scene.json", "--jsonl", a, other, b});
      EXPECT_EQ(run.exit_code, 2) << a << ' ' << b;
      EXPECT_EQ(run.out, "");
      EXPECT_NE(run.err.find(other + ": " + b + " is the output of --jsonl"), std::string::npos)
          << run.err;
    }
  }
  const Ended shell =
      run_in_shell(folder, shell_command({"check", "scene.json", "--jsonl", "said"}) + " > said");
  EXPECT_EQ(shell.exit_code, 2);
  EXPECT_NE(shell.err.find("said is where standard output goes"), std::string::npos) << shell.err;
  fs::remove(folder / "said");
  EXPECT_TRUE(folder.contents() == before);
}

TEST(Outputs, AreNotAnInputThatIsADescriptor) {
  const SafetyFolder folder;
  write_bytes(folder / "a.glb", build_limb(12).glb());
  ASSERT_EQ(run_pelt(folder.get(), {"check", "scene.json", "--jsonl", "known"}).exit_code, 1);
  ASSERT_EQ(run_pelt(folder.get(), {"prepare", "a.glb", "-o", "a.pelt"}).exit_code, 0);
  const auto before = folder.contents();
  const std::vector<std::pair<std::string, std::string>> scripts = {
      {"check /dev/stdin a.gltf --jsonl a.glb <a.glb", "--jsonl: a.glb is the model /dev/stdin"},
      {"check /dev/fd/9 a.gltf --glb ./a.glb 9<a.glb", "--glb: ./a.glb is the model /dev/fd/9"},
      {"check scene.json --baseline /dev/stdin --jsonl known <known",
       "--jsonl: known is the baseline /dev/stdin"},
      {"check scene.json --baseline known >>known", "standard output: goes to the baseline known"},
      {"bounds /dev/stdin --jsonl a.glb <a.glb", "--jsonl: a.glb is the model /dev/stdin"},
      {"pose /dev/stdin --frame 0 -o a.glb <a.glb", "--output: a.glb is the model /dev/stdin"},
      {"prepare /dev/stdin -o a.glb <a.glb", "--output: a.glb is the model /dev/stdin"},
      {"info a.glb >>a.glb", "standard output: goes to the model a.glb"},
      {"info /dev/stdin <a.glb >>a.glb", "standard output: goes to the model /dev/stdin"},
      {"info a.gltf --json >>a.bin", "standard output: goes to a file of the model a.gltf"},
      {"info a.pelt >>a.pelt", "standard output: goes to the prepared model a.pelt"},
      {"view a.glb --no-browser >>a.glb", "standard output: goes to the model a.glb"},
      {"bench scene.json >>scene.json", "standard output: goes to the scene scene.json"}};
  for (const auto& [script, message] : scripts) {
    const Ended run = run_in_shell(folder, "timeout 60 '" PELT_COMMAND "' " + script);
    EXPECT_EQ(run.exit_code, 2) << script;
    EXPECT_NE(run.err.find(message), std::string::npos) << script << run.err;
    EXPECT_TRUE(folder.contents() == before) << script;
  }
}

TEST(Outputs, ShareNoDescriptorPipeOrDevice) {
  const SafetyFolder folder;
  const auto before = folder.contents();
  for (const std::string script :
       {"--jsonl /dev/fd/9 --glb /dev/fd/9 9>new", "--jsonl /dev/fd/9 --glb /dev/fd/9 9>&2",
        "--jsonl /dev/fd/8 --glb /dev/fd/9 9>new 8>&9", "--jsonl new --glb /dev/fd/9 9>new",
        "--jsonl /dev/fd/9 --glb new 9>new", "--jsonl - --glb /dev/fd/9 9>&1 | cat",
        "--jsonl /dev/fd/9 --glb - 9>&1 | cat", "--jsonl pipe --html pipe",
        "--jsonl /dev/zero --glb /dev/zero", "--jsonl - --glb - >/dev/null"}) {
    const Ended run = run_in_shell(folder, "set -o pipefail; mkfifo pipe; timeout 60 '" PELT_COMMAND
                                           "' check scene.json " +
                                               script + "; code=$?; rm -f pipe new; exit $code");
    EXPECT_EQ(run.exit_code, 2) << script;
    EXPECT_NE(run.err.find(" is the output of --"), std::string::npos) << script << run.err;
    EXPECT_TRUE(folder.contents() == before) << script;
  }
  const Ended shared = run_in_shell(
      folder, shell_command({"check", "scene.json", "--jsonl", "/dev/fd/9"}) + " 9>said >said");
  EXPECT_EQ(shared.exit_code, 2);
  EXPECT_NE(shared.err.find("/dev/fd/9 is where standard output goes"), std::string::npos);
}

TEST(Outputs, MayShareTheNullDevice) {
  const SafetyFolder folder;
  for (const std::string script : {"--jsonl /dev/null --glb /dev/null --html /dev/null",
                                   "--jsonl /dev/fd/9 --glb /dev/null 9>/dev/null"}) {
    const Ended run = run_in_shell(
        folder, "'" PELT_COMMAND "' check scene.json --fail-on never " + script + " >/dev/null");
    EXPECT_EQ(run.exit_code, 0) << script << run.err;
  }
}

TEST(Outputs, AreNotTheBaseline) {
  const SafetyFolder folder;
  ASSERT_EQ(run_pelt(folder.get(), {"check", "scene.json", "--jsonl", "known"}).exit_code, 1);
  const auto before = folder.contents();
  for (const std::string option : {"--jsonl", "--glb", "--html"}) {
    const Ended run =
        run_pelt(folder.get(), {"check", "scene.json", "--baseline", "known", option, "./known"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find(option + ": ./known is the baseline known"), std::string::npos)
        << run.err;
  }
  EXPECT_TRUE(folder.contents() == before);
  Words bench = writers().back().words;
  ASSERT_EQ(run_pelt(folder.get(), with(bench, "figures.json")).exit_code, 0);
  bench.insert(bench.end() - 1, {"--against", "figures.json"});
  const Ended run = run_pelt(folder.get(), with(bench, "figures.json"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--json: figures.json is what --against"), std::string::npos) << run.err;
}

TEST(Outputs, KeepAReadOnlyFile) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may write everything";
  const SafetyFolder folder;
  write_text(folder / "old", kOld);
  fs::permissions(folder / "old", fs::perms::owner_read);
  const Ended run = run_pelt(folder.get(), {"bounds", "scene.json", "--jsonl", "old"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(read_text(folder / "old"), kOld);
}

TEST(Outputs, OfADemoAreFilesOfTheirOwn) {
  const SafetyFolder folder;
  fs::create_directory(folder / "pelt-demo");
  fs::create_symlink("scene.json", folder / "pelt-demo/contacts.glb");
  Ended run = run_pelt(folder.get(), {"demo", "--no-picture"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("contacts.glb is the output of -o"), std::string::npos) << run.err;
  fs::remove(folder / "pelt-demo/contacts.glb");
  fs::create_symlink("../viewer.html", folder / "pelt-demo/report.html");
  run = run_pelt(folder.get(), {"demo", "--no-picture"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(read_text(folder / "viewer.html"), viewer_page(PELT_VERSION));
  EXPECT_EQ(names_in_path(folder / "pelt-demo"), std::set<std::string>{"report.html"});
}

TEST(Outputs, OfADemoAreAsBeforeOnAFullDiskOrASignal) {
  const SafetyFolder folder;
  ASSERT_EQ(run_pelt(folder.get(), {"demo", "--no-picture"}).exit_code, 0);
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
