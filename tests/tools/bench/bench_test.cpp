/// `pelt bench`: its tables, its figures as JSON, and what it refuses.

#include "tools/test_scenes.hpp"

#include <iterator>
#include <regex>
#include <set>

namespace pelt::test {
namespace {

Ended bench(const TestFolder& folder, const Words& words) {
  return run_pelt(folder, joined({"bench", "--repeat", "1"}, words));
}

json figures_of(const TestFolder& folder, Words words) {
  words.insert(words.end(), {"--json", "a.json"});
  const Ended run = bench(folder, words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(read_text(folder / "a.json"));
}

json figures(const TestFolder& folder, const Words& options) {
  return figures_of(folder, joined({"scene.json"}, options));
}

TEST(Bench, WritesFiguresOfEveryMethod) {
  const LimbsFolder folder;
  const json file = figures(folder, {"--methods", "paper,on_demand,eager,brute", "--queries", "all",
                                     "--frames", "2:11:2"});
  EXPECT_EQ(file["format"], "pelt-bench");
  EXPECT_EQ(file["version"], 1);
  EXPECT_TRUE(file["machine"].contains("cpu"));
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "scene.json");
  EXPECT_EQ(scene["time"], "thread");
  EXPECT_EQ(scene["frames"], 5);
  EXPECT_GT(scene["frames_in_contact"], 0);
  EXPECT_GT(scene["skinning"]["ns_per_vertex"], 0);
  EXPECT_GT(scene["models"]["bytes"], scene["models"]["triangles"]);
  ASSERT_EQ(scene["methods"].size(), 4u);
  for (const json& method : scene["methods"]) {
    EXPECT_EQ(method["query"], "all");
    EXPECT_EQ(method["cache"], "hot");
    EXPECT_EQ(method["asked"], "pairs");
    EXPECT_EQ(method["threads"], 1);
    EXPECT_EQ(method["frames"], 5);
    EXPECT_GT(method["mean_us"], method["mean_update_us"]);
    EXPECT_GT(method["mean_contact_us"], 0);
    EXPECT_GE(method["p95_us"], method["mean_update_us"]);
    EXPECT_EQ(method["hash"], scene["methods"][0]["hash"]);
  }
  EXPECT_EQ(scene["methods"][2]["method"], "eager");
}

TEST(Bench, MeasuresThreeMethodsAndTwoQueriesByDefault) {
  const LimbsFolder folder;
  const json file = figures(folder, {});
  std::set<json> different;
  for (const json& method : file["scenes"][0]["methods"])
    different.insert(json::array({method["method"], method["query"], method["cache"]}));
  std::set<json> expected;
  for (const char* name : {"paper", "eager", "on_demand"})
    for (const char* query : {"all", "first"}) expected.insert(json::array({name, query, "hot"}));
  EXPECT_EQ(different, expected);
}

TEST(Bench, RefusesASceneWithoutAPair) {
  const LimbsFolder folder;
  json scene = json::parse(read_text(folder / "scene.json"));
  scene["instances"].erase(1);
  write_text(folder / "alone.json", scene.dump());
  const Ended run = run_pelt(folder, 2, {"bench", "alone.json"});
  EXPECT_TRUE(contains(run.err, "alone.json: has 1 instance, so there is no pair to measure"));
}

TEST(Bench, QueriesACrowdOnTheGivenThreads) {
  const LimbsFolder folder;
  const json file = figures(folder, {"--methods", "paper,on_demand", "--threads", "2,1,2,3"});
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["time"], "wall");
  ASSERT_EQ(scene["methods"].size(), 8u);
  const std::uint32_t threads[] = {1, 2, 1, 3};
  for (std::size_t i = 0; i < 8; ++i) {
    const json& method = scene["methods"][i];
    EXPECT_EQ(method["method"], i % 4 == 0 ? "paper" : "on_demand");
    EXPECT_EQ(method["asked"], i % 4 == 0 ? "pairs" : "crowd");
    EXPECT_EQ(method["threads"], threads[i % 4]);
    EXPECT_EQ(method["hash"], scene["methods"][i - i % 4]["hash"]);
    EXPECT_GT(method["mean_us"], 0);
    if (i % 4 > 1) {
      EXPECT_EQ(method["counters"], scene["methods"][i - 1]["counters"]);
    }
  }
}

/// The cells of a line of a table, by the column heads.
std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(Bench, ComparesThreadsWithOne) {
  const LimbsFolder folder;
  const auto ratios = [&](const char* threads) {
    const Ended run =
        run_pelt(folder, 0,
                 {"bench", "scene.json", "--repeat", "1", "--methods", "eager,on_demand",
                  "--queries", "all", "--frames", "4:7", "--threads", threads});
    EXPECT_TRUE(contains(run.out, "wall time"));
    std::vector<std::string> found;
    for (const std::string& line : lines_of(run.out)) {
      const std::vector<std::string> cells = cells_of(line);
      if (cells.size() == 10 && (cells[0] == "eager" || cells[0] == "on_demand"))
        found.push_back(cells[1] + " " + cells[9]);
    }
    return found;
  };
  const std::vector<std::string> both = ratios("1,2");
  ASSERT_EQ(both.size(), 3u);
  EXPECT_EQ(both[0], "1 -") << "eager has no threads";
  EXPECT_EQ(both[1], "1 1.00");
  EXPECT_EQ(both[2].substr(0, 2), "2 ");
  EXPECT_GT(std::stod(both[2].substr(2)), 0);
  EXPECT_EQ(ratios("2"), (std::vector<std::string>{"1 -", "2 -"})) << "nothing to compare with";
}

TEST(Bench, HashIsThatOfCheck) {
  const LimbsFolder folder;
  const json file = figures(folder, {"--methods", "on_demand"});
  const Ended check = run_pelt(folder, {"check", "scene.json"});
  EXPECT_TRUE(contains(check.out, file["scenes"][0]["methods"][0]["hash"].get<std::string>()));
}

TEST(Bench, FirstNeedsLessWork) {
  const LimbsFolder folder;
  const json file = figures(folder, {"--methods", "paper,eager"});
  const json& methods = file["scenes"][0]["methods"];
  for (const int e : {0, 1}) {
    const json &all = methods[e], &first = methods[e + 2];
    EXPECT_EQ(all["method"], first["method"]);
    EXPECT_EQ(first["query"], "first");
    EXPECT_EQ(first["hash"], methods[2]["hash"]);
    EXPECT_NE(first["hash"], all["hash"]);
    EXPECT_LT(first["counters"]["triangle_pairs"], all["counters"]["triangle_pairs"]);
  }
}

TEST(Bench, FramesWithoutContactHaveNoMean) {
  const LimbsFolder folder;
  const json file = figures(folder, {"--methods", "paper", "--frames", "0:1"});
  const json& method = file["scenes"][0]["methods"][0];
  EXPECT_EQ(method["mean_contact_us"], json());
}

TEST(Bench, PrintsTablesForEachScene) {
  const LimbsFolder folder;
  const Ended run = run_pelt(
      folder, 0, {"bench", "scene.json", "scene.json", "--repeat", "1", "--frames", "5:6"});
  const std::vector<std::string> lines = lines_of(run.out);
  const auto count = [&](const std::string& begin) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.rfind(begin, 0) == 0; });
  };
  EXPECT_EQ(count("scene.json: "), 2);
  EXPECT_EQ(count("query "), 4);
  EXPECT_EQ(count("on_demand "), 8);  // two tables of times and two lines of work for each scene
  EXPECT_EQ(count("all "), 2);        // vertices skinned
  for (const char* words : {"in contact", "update", "posed vertices", "by every", "vs paper",
                            "vs eager", "bytes per triangle", "ns per vertex"}) {
    EXPECT_TRUE(contains(run.out, words));
  }
  EXPECT_FALSE(contains(run.out, "of rigid")) << "pelt-lab has that method";
}

TEST(Bench, SaysThatFewRepetitionsAreARoughLook) {
  const LimbsFolder folder;
  const auto is_rough = [&](const char* repetitions) {
    const Ended run = run_pelt(folder, 0,
                               {"bench", "scene.json", "--methods", "on_demand", "--frames", "5:6",
                                "--repeat", repetitions});
    return run.out.find("rough measurement") != std::string::npos;
  };
  EXPECT_TRUE(is_rough("1"));
  EXPECT_TRUE(is_rough("8"));
  EXPECT_FALSE(is_rough("9"));
}

TEST(Bench, FileThatCannotBeWrittenIsRefusedBeforeAnyIsMeasured) {
  const LimbsFolder folder;
  for (const char* path : {"no/folder/figures.json", "."}) {
    const Ended run = bench(folder, {"scene.json", "--json", path});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(contains(run.err, std::string(path) + ": cannot be written"));
  }
}

/// If measuring fails, no new file remains and no old file changes.
TEST(Bench, FileIsAsItWasAfterAFailure) {
  const TestFolder folder;
  write_text(folder / "old.json", "precious");
  for (const char* path : {"old.json", "new.json"})
    EXPECT_EQ(bench(folder, {"none.json", "--json", path}).exit_code, 2);
  EXPECT_EQ(read_text(folder / "old.json"), "precious");
  EXPECT_FALSE(std::filesystem::exists(folder / "new.json"));
}

// --- characters against themselves

Ended bench_self(const TestFolder& folder, Words words) {
  words.insert(words.end(), {"--frames", "0:3"});
  return bench(folder, words);
}

json self_figures(const TestFolder& folder, Words words) {
  words.insert(words.end(), {"--frames", "0:3"});
  return figures_of(folder, words);
}

TEST(BenchSelf, MeasuresAModelAgainstItself) {
  const StripFolder folder;
  const json file =
      self_figures(folder, {"strip.glb", "--clip", "bend", "--methods", "boxes,self,brute"});
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "strip.glb bend");
  EXPECT_EQ(scene["frames_in_contact"], 3);
  EXPECT_GT(scene["models"]["self_filter_bytes"], 0);
  EXPECT_GT(scene["models"]["self_filter_build_seconds"], 0);
  EXPECT_GT(scene["sequence"]["self_us"], 0);
  EXPECT_GT(scene["sequence"]["tracked_us"], 0);
  const json& methods = scene["methods"];
  ASSERT_EQ(methods.size(), 6u);
  for (std::size_t e = 0; e < 6; ++e) {
    EXPECT_EQ(methods[e]["asked"], e % 3 == 0 ? "none" : "self");
    EXPECT_EQ(methods[e]["query"], e < 3 ? "all" : "first");
    EXPECT_EQ(methods[e]["hash"], methods[e < 3 ? 0 : 3]["hash"]);
    EXPECT_GT(methods[e]["mean_us"], 0);
    EXPECT_EQ(methods[e]["counters"]["triangle_pairs"] > 0, e % 3 != 0);
  }
  EXPECT_NE(methods[0]["hash"], methods[3]["hash"]);
}

TEST(BenchSelf, HashIsThatOfCheckWithoutFilters) {
  const StripFolder folder;
  const json file = self_figures(folder, {"strip.glb", "--clip", "bend"});
  const Ended check =
      run_pelt(folder, 1,
               {"check", "strip.glb", "--clip", "bend", "--frames", "0:3", "--self-rings", "0",
                "--self-at-rest", "keep", "--self-near-joints", "keep"});
  EXPECT_TRUE(contains(check.out, file["scenes"][0]["methods"][0]["hash"].get<std::string>()));
}

/// The words of the rows of `method` in all tables of times.
std::vector<std::vector<std::string>> rows_of(const std::string& text, const std::string& method) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(text)) {
    std::istringstream stream(line);
    const Words words{std::istream_iterator<std::string>(stream), {}};
    if (words.size() > 6 && words[0] == method && words[1] == "1") rows.push_back(words);
  }
  return rows;
}

TEST(BenchSelf, PrintsCostsOverBoxes) {
  const StripFolder folder;
  const Ended run = bench_self(folder, {"strip.glb", "--clip", "bend"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* words : {"self filters: built in ", "of boxes", "vs all", "by every method",
                            "frames in order, all contacts: self "})
    EXPECT_TRUE(contains(run.out, words));
  for (const char* words : {"vs paper", "vs eager", "vs 1 thread", "of rigid"})
    EXPECT_FALSE(contains(run.out, words));
  const auto boxes = rows_of(run.out, "boxes"), self = rows_of(run.out, "self");
  ASSERT_EQ(boxes.size(), 2u);
  ASSERT_EQ(self.size(), 2u);
  EXPECT_EQ(boxes[0].back(), "1.00");
  EXPECT_GT(std::stod(self[0].back()), 0);
  EXPECT_EQ(self[1].size(), self[0].size() + 1) << "only first contacts are compared with all";
}

TEST(BenchSelf, PlaysTheClipAtTheChosenRate) {
  const StripFolder folder;
  const auto frames = [&](const char* fps) {
    const json file = figures_of(folder, {"strip.glb", "--clip", "bend", "--fps", fps});
    return file["scenes"][0]["frames"].get<int>();
  };
  EXPECT_EQ(frames("60"), 2 * frames("30"));
}

TEST(BenchSelf, MeasuresEachInstanceOfAScene) {
  const LimbsFolder folder;
  const json file = self_figures(folder, {"scene.json", "--self"});
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "scene.json --self");
  ASSERT_EQ(scene["methods"].size(), 4u);
  EXPECT_EQ(scene["methods"][1]["method"], "self");
  EXPECT_GT(scene["methods"][1]["counters"]["posed_vertices"], 0);
}

TEST(BenchSelf, RefusesWhatItCannotMeasure) {
  const StripFolder folder;
  write_limbs(folder);
  const std::pair<std::vector<std::string>, const char*> refused[] = {
      {{"strip.glb", "scene.json"}, "add --self, or start a run for each"},
      {{"scene.json", "--clip", "sway"}, "--clip: applies to models, not to a scene file"},
      {{"strip.glb", "--clip", "bend", "--clip", "bend"}, "at most once per model"},
      {{"strip.glb", "--clip", "bent"}, "did you mean \"bend\""},
      {{"strip.glb", "--methods", "paper"}, "--methods: unknown value \"paper\""},
      {{"scene.json", "--methods", "boxes"}, "--methods: unknown value \"boxes\""},
      {{"strip.glb", "--threads", "2"}, "for pairs of instances"},
  };
  for (const auto& [words, message] : refused) {
    const Ended run = bench_self(folder, words);
    EXPECT_EQ(run.exit_code, 2) << words[0];
    EXPECT_TRUE(contains(run.err, message));
    EXPECT_EQ(run.out, "");
  }
}

// --- figures as JSON, as the manual page and the help list them

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
  return paths_of(figures(folder, {"--methods", "on_demand", "--frames", "4:6", "--threads", "1"}));
}

/// The same, and what is written only for a character against itself.
Paths all_paths(const TestFolder& folder) {
  Paths paths = written_paths(folder);
  paths.merge(paths_of(figures_of(folder, {"one.glb"})));
  return paths;
}

/// The section of the manual page on figures.
std::string manual_section() {
  const std::string page = read_text(std::string(PELT_DOCS_DIR) + "/pelt.1");
  const std::size_t begin = page.find(".SS \"Figures (");
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
  for (const std::string& path : all_paths(folder)) {
    const std::string name = path.substr(path.find_last_of('.') + 1);
    EXPECT_TRUE(std::regex_search(fields, std::regex("\\b" + name + "\\b"))) << name;
  }
}

}  // namespace
}  // namespace pelt::test
