/// --help, its examples, and the manual page.

#include "tools/test_scenes.hpp"

#include <regex>

namespace pelt::test {
namespace {

constexpr const char* kVerbs[] = {"check",    "merge", "view",    "bounds", "ray",  "region",
                                  "distance", "info",  "prepare", "pose",   "demo", "bench"};

TEST(Help, NamesEveryVerb) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, 0, {"--help"});
  for (const char* verb : kVerbs) EXPECT_TRUE(contains(run.out, verb));
}

TEST(Help, PrintsTheVersion) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, 0, {"--version"});
  EXPECT_EQ(run.out, "pelt 0.1.0\n");
}

/// A strip whose clips have the names of the examples.
void write_character(const TestFolder& folder, const std::string& name) {
  GltfBuilder builder = strip_with_fan();
  builder.document["animations"][0]["name"] = "Walk";
  builder.document["animations"][1]["name"] = "Attack";
  write_bytes(folder / name, builder.glb());
}

/// The lines after "Examples:" that call pelt.
std::vector<std::string> examples_of(const std::string& help) {
  std::vector<std::string> examples;
  for (const std::string& line : lines_of(help.substr(help.find("Examples:")))) {
    if (line.rfind("  pelt ", 0) == 0) examples.push_back(line.substr(7));
  }
  return examples;
}

/// Removes the quotes, which only a shell needs.
std::vector<std::string> words_of(std::string text) {
  std::erase(text, '\'');
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word && word != ">";) words.push_back(word);
  return words;
}

class HelpExamples : public ::testing::TestWithParam<const char*> {};

TEST_P(HelpExamples, Run) {
  const TestFolder folder;
  const std::string verb = GetParam();
  const Ended help = run_pelt(folder, 0, {verb, "--help"});
  // A scene with the frames that the examples use, some of them in contact.
  std::string scene = kLimbsScene;
  scene.replace(scene.find("\"count\": 12, \"fps\": 6"), 21, "\"count\": 60, \"fps\": 30");
  write_limbs(folder);
  write_text(folder / "scene.json", scene);
  write_text(folder / "scenes.txt", "scene.json\nknight.glb\n");
  write_character(folder, "knight.glb");
  write_character(folder, "barbarian.glb");
  const std::vector<std::string> examples = examples_of(help.out);
  EXPECT_GE(examples.size(), 2u);
  for (const std::string& example : examples) {
    Words words = words_of(example);
    if (verb == "bench" && example.find("--repeat") == example.npos)
      words.insert(words.end(), {"--repeat", "1"});  // nine times would take minutes
    const Ended run = run_pelt(folder, words, "/nonexistent");
    EXPECT_TRUE(run.exit_code == 0 || ((verb == "check" || verb == "merge") && run.exit_code == 1))
        << "pelt " << example << " ended with " << run.exit_code << "\n"
        << run.err;
  }
}

// `demo` has a test of its own, because it takes long.
INSTANTIATE_TEST_SUITE_P(Verbs, HelpExamples,
                         ::testing::Values("check", "merge", "bounds", "ray", "region", "distance",
                                           "info", "prepare", "pose", "bench"));

TEST(Manual, HasEveryVerbAndOption) {
  const TestFolder folder;
  std::string page = read_text(std::string(PELT_DOCS_DIR) + "/pelt.1");
  page = std::regex_replace(page, std::regex("\\\\-"), "-");
  const std::regex option("--[a-z][a-z-]+");
  for (const char* verb : kVerbs) {
    const std::string help = run_pelt(folder, {verb, "--help"}).out;
    EXPECT_TRUE(contains(page, std::string(".SS ") + verb + "\n")) << verb;
    for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match) {
      EXPECT_TRUE(contains(page, match->str())) << verb;
    }
  }
}

/// The options of a verb as lines of a manual page, in the order of --help.
std::string manual_of_options(const std::string& help) {
  const std::regex option("^  (--?[a-z][a-z-]*)( (?:[^ :=]|:(?![0-9]))+)?");
  std::vector<std::string> lines;
  for (const std::string& line : lines_of(help.substr(0, help.find("Examples:")))) {
    std::smatch match;
    if (!std::regex_search(line, match, option)) continue;
    const std::string name = match[1], type = match[2];
    if (name == "-h" || name == "--help-all") continue;
    const std::string escaped = std::regex_replace(name, std::regex("-"), "\\-");
    const bool is_flag = type.empty() || type.starts_with(" Excludes");
    lines.push_back(is_flag ? ".BR " + escaped + " " : ".BI " + escaped + " \"" + type + "\" ");
  }
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += lines[i] + (i + 1 < lines.size() ? ",\n" : ".\n");
  return text;
}

TEST(Manual, ListsTheOptionsOfCheck) {
  const TestFolder folder;
  const std::string list = manual_of_options(run_pelt(folder, {"check", "--help"}).out);
  EXPECT_GT(std::count(list.begin(), list.end(), '\n'), 40);
  const std::string page = read_text(std::string(PELT_DOCS_DIR) + "/pelt.1");
  EXPECT_TRUE(contains(page, "writes this list.\n" + list + ".PP\n"))
      << "write this list into docs/pelt.1:\n"
      << list;
}

TEST(Manual, IsWithoutFault) {
  const std::string page = std::string(PELT_DOCS_DIR) + "/pelt.1";
  const Ended run = run_program(".", {"groff", "-ww", "-man", "-z", "-Tutf8", page});
  if (run.exit_code == 127) GTEST_SKIP() << "groff is not installed";
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
}

}  // namespace
}  // namespace pelt::test
