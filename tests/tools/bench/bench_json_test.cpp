/// `pelt bench --json` writes the figures that the manual page and the help list.

#include "tools/test_scenes.hpp"

#include <regex>
#include <set>

namespace pelt::test {
namespace {

using Paths = std::set<std::string>;

/// Collects the paths of numbers, texts and nulls: "scenes[].methods[].mean_us".
void collect_paths(const json& value, const std::string& path, Paths& paths) {
  if (value.is_array()) {
    for (const json& element : value) collect_paths(element, path + "[]", paths);
  } else if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      collect_paths(member, path.empty() ? key : path + "." + key, paths);
  } else {
    paths.insert(path);
  }
}

Paths paths_of(const json& value) {
  Paths paths;
  collect_paths(value, "", paths);
  return paths;
}

Paths written_paths(const TestFolder& folder) {
  write_limbs(folder);
  const Ended run =
      run_pelt(folder, {"bench", "scene.json", "--repeat", "1", "--methods", "on_demand",
                        "--frames", "4:6", "--threads", "1", "--json", "figures.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return paths_of(json::parse(read_text(folder / "figures.json")));
}

/// The same, and what is written only for a character against itself.
Paths all_paths(const TestFolder& folder) {
  Paths paths = written_paths(folder);
  const Ended run = run_pelt(
      folder, {"bench", "one.glb", "--repeat", "1", "--caches", "hot", "--json", "self.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  paths.merge(paths_of(json::parse(read_text(folder / "self.json"))));
  return paths;
}

Paths moving_paths(const TestFolder& folder) {
  write_limbs(folder);
  const Ended run = run_pelt(folder, {"bench", "scene.json", "--moving", "--repeat", "1",
                                      "--frames", "4:6", "--json", "moving.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return paths_of(json::parse(read_text(folder / "moving.json")));
}

Paths anytime_paths(const TestFolder& folder) {
  write_limbs(folder);
  const Ended run = run_pelt(folder, {"bench", "scene.json", "--anytime", "--repeat", "1",
                                      "--frames", "5:6", "--json", "anytime.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return paths_of(json::parse(read_text(folder / "anytime.json")));
}

/// The section of the manual page whose title begins so.
std::string manual_section(const std::string& title = "Figures (") {
  const std::string page = read_text(std::string(PELT_DOCS_DIR) + "/pelt.1");
  const std::size_t begin = page.find(".SS \"" + title);
  const std::size_t end = page.find("\n.S", begin + 1);
  return std::regex_replace(page.substr(begin, end - begin), std::regex("\\\\-"), "-");
}

/// The fields that a section of the manual page describes.
Paths described_in(const std::string& section) {
  const std::regex item("\\.TP\n\\.B (\\S+)\n");
  Paths told;
  for (std::sregex_iterator match(section.begin(), section.end(), item), end; match != end; ++match)
    EXPECT_TRUE(told.insert((*match)[1]).second) << (*match)[1] << " is told twice";
  return told;
}

TEST(BenchJson, ManualDescribesEveryFieldAndNoOther) {
  const TestFolder folder;
  EXPECT_EQ(described_in(manual_section()), all_paths(folder));
}

TEST(BenchJson, ManualDescribesEveryFieldOfMovingAndNoOther) {
  const TestFolder folder;
  EXPECT_EQ(described_in(manual_section("Figures of steps (")), moving_paths(folder));
}

TEST(BenchJson, ManualDescribesEveryFieldOfAnytimeAndNoOther) {
  const TestFolder folder;
  EXPECT_EQ(described_in(manual_section("Figures of searches (")), anytime_paths(folder));
}

TEST(BenchJson, ManualsExampleHasTheFieldsThatAreWritten) {
  const TestFolder folder;
  const std::string section = manual_section();
  const std::size_t begin = section.find(".nf\n") + 4;
  const json example = json::parse(section.substr(begin, section.find(".fi", begin) - begin));
  EXPECT_EQ(paths_of(example), written_paths(folder));
}

TEST(BenchJson, HelpNamesEveryField) {
  const TestFolder folder;
  const std::string help = run_pelt(folder, {"bench", "--help"}).out;
  const std::string fields = help.substr(help.find("--json writes"));
  Paths paths = all_paths(folder);
  paths.merge(moving_paths(folder));
  for (const std::string& path : paths) {
    const std::string name = path.substr(path.find_last_of('.') + 1);
    EXPECT_TRUE(std::regex_search(fields, std::regex("\\b" + name + "\\b"))) << name;
  }
}

}  // namespace
}  // namespace pelt::test
