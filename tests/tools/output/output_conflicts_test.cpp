/// No output overwrites an input or another output.

#include "tools/output/writers.hpp"

namespace pelt::test {
namespace {

namespace fs = std::filesystem;

class OutputConflict : public ::testing::TestWithParam<Writer> {};

INSTANTIATE_TEST_SUITE_P(Verbs, OutputConflict, ::testing::ValuesIn(writers()), name_of_writer);

TEST_P(OutputConflict, IsNoInput) {
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
  if (GetParam().name.starts_with("check") || GetParam().name == "view")
    inputs.push_back("viewer.html");
  const auto before = folder.contents();
  for (const std::string& input : inputs) {
    const Ended run = run_pelt(folder, 2, with(GetParam().words, input));
    EXPECT_EQ(run.out, "") << input;
    EXPECT_TRUE(contains(run.err, input + " is "));
    EXPECT_TRUE(contains(run.err, ": name another file"));
    EXPECT_TRUE(folder.contents() == before) << input;
  }
}

/// Scripts of the shell in which "..." is the command, and "a.gltf" an input.
TEST_P(OutputConflict, IsNoInputThroughADescriptor) {
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
    EXPECT_TRUE(contains(run.err, message)) << script;
    EXPECT_TRUE(folder.contents() == before) << script;
  }
}

TEST(OutputConflicts, AreNotEachOther) {
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
      const Ended run = run_pelt(folder, {"check", "scene.json", "--jsonl", a, other, b});
      EXPECT_EQ(run.exit_code, 2) << a << ' ' << b;
      EXPECT_EQ(run.out, "");
      EXPECT_TRUE(contains(run.err, other + ": " + b + " is the output of --jsonl"));
    }
  }
  const Ended shell =
      run_in_shell(folder, shell_command({"check", "scene.json", "--jsonl", "said"}) + " > said");
  EXPECT_EQ(shell.exit_code, 2);
  EXPECT_TRUE(contains(shell.err, "said is where standard output goes"));
  fs::remove(folder / "said");
  EXPECT_TRUE(folder.contents() == before);
}

TEST(OutputConflicts, AreNotAnInputThatIsADescriptor) {
  const SafetyFolder folder;
  write_bytes(folder / "a.glb", build_limb(12).glb());
  run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "known"});
  run_pelt(folder, 0, {"prepare", "a.glb", "-o", "a.pelt"});
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
    EXPECT_TRUE(contains(run.err, message)) << script;
    EXPECT_TRUE(folder.contents() == before) << script;
  }
}

TEST(OutputConflicts, ShareNoDescriptorPipeOrDevice) {
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
    EXPECT_TRUE(contains(run.err, " is the output of --")) << script;
    EXPECT_TRUE(folder.contents() == before) << script;
  }
  const Ended shared = run_in_shell(
      folder, shell_command({"check", "scene.json", "--jsonl", "/dev/fd/9"}) + " 9>said >said");
  EXPECT_EQ(shared.exit_code, 2);
  EXPECT_TRUE(contains(shared.err, "/dev/fd/9 is where standard output goes"));
}

TEST(OutputConflicts, MayShareTheNullDevice) {
  const SafetyFolder folder;
  for (const std::string script : {"--jsonl /dev/null --glb /dev/null --html /dev/null",
                                   "--jsonl /dev/fd/9 --glb /dev/null 9>/dev/null"}) {
    const Ended run = run_in_shell(
        folder, "'" PELT_COMMAND "' check scene.json --fail-on never " + script + " >/dev/null");
    EXPECT_EQ(run.exit_code, 0) << script << run.err;
  }
}

TEST(OutputConflicts, AreNotTheBaseline) {
  const SafetyFolder folder;
  run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "known"});
  const auto before = folder.contents();
  for (const std::string option : {"--jsonl", "--glb", "--html"}) {
    const Ended run =
        run_pelt(folder, 2, {"check", "scene.json", "--baseline", "known", option, "./known"});
    EXPECT_TRUE(contains(run.err, option + ": ./known is the baseline known"));
  }
  EXPECT_TRUE(folder.contents() == before);
}

TEST(OutputConflicts, OfADemoAreFilesOfTheirOwn) {
  const SafetyFolder folder;
  fs::create_directory(folder / "pelt-demo");
  fs::create_symlink("scene.json", folder / "pelt-demo/contacts.glb");
  Ended run = run_pelt(folder, {"demo", "--no-picture"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.err, "contacts.glb is the output of -o"));
  fs::remove(folder / "pelt-demo/contacts.glb");
  fs::create_symlink("../viewer.html", folder / "pelt-demo/report.html");
  run = run_pelt(folder, {"demo", "--no-picture"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(read_text(folder / "viewer.html"), viewer_page(PELT_VERSION));
  EXPECT_EQ(names_in_path(folder / "pelt-demo"), std::set<std::string>{"report.html"});
}

}  // namespace
}  // namespace pelt::test
