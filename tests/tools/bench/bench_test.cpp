#include "tools/test_scenes.hpp"

#include <iterator>
#include <set>

namespace pelt::test {
namespace {

json figures(const TestFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {"bench", "scene.json", "--repeat", "1", "--json", "a.json"});
  const Ended run = run_pelt(folder, options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(read_text(folder / "a.json"));
}

TEST(Bench, WritesFiguresOfEveryMethod) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "paper,on_demand,eager,brute", "--queries", "all",
                                     "--caches", "hot", "--frames", "2:11:2"});
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

TEST(Bench, MeasuresThreeMethodsTwoQueriesAndTwoCachesByDefault) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {});
  const json& methods = file["scenes"][0]["methods"];
  ASSERT_EQ(methods.size(), 12u);
  std::set<json> different;
  for (const json& method : methods)
    different.insert(json::array({method["method"], method["query"], method["cache"]}));
  EXPECT_EQ(different.size(), 12u);
  for (const char* name : {"paper", "eager", "on_demand"})
    EXPECT_EQ(different.count(json::array({name, "first", "cold"})), 1u) << name;
}

TEST(Bench, RefusesASceneWithoutAPair) {
  const TestFolder folder;
  write_limbs(folder);
  json scene = json::parse(read_text(folder / "scene.json"));
  scene["instances"].erase(1);
  write_text(folder / "alone.json", scene.dump());
  const Ended run = run_pelt(folder, {"bench", "alone.json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("alone.json: has 1 instance, so there is no pair to measure"),
            std::string::npos)
      << run.err;
}

TEST(Bench, QueriesACrowdOnTheGivenThreads) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "paper,on_demand", "--threads", "2,1,2,3"});
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["time"], "wall");
  ASSERT_EQ(scene["methods"].size(), 16u);
  const std::uint32_t threads[] = {1, 2, 1, 3};
  for (std::size_t i = 0; i < 16; ++i) {
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
  const TestFolder folder;
  write_limbs(folder);
  const auto ratios = [&](const char* threads) {
    const Ended run = run_pelt(
        folder, {"bench", "scene.json", "--repeat", "1", "--methods", "eager,on_demand",
                 "--queries", "all", "--caches", "hot", "--frames", "4:7", "--threads", threads});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("wall time"), std::string::npos);
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
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "on_demand"});
  const Ended check = run_pelt(folder, {"check", "scene.json"});
  EXPECT_NE(check.out.find(file["scenes"][0]["methods"][0]["hash"].get<std::string>()),
            std::string::npos);
}

TEST(Bench, FirstNeedsLessWork) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "paper,eager", "--caches", "hot"});
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
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "paper", "--caches", "cold", "--frames", "0:1"});
  const json& method = file["scenes"][0]["methods"][0];
  EXPECT_EQ(method["cache"], "cold");
  EXPECT_EQ(method["mean_contact_us"], json());
}

TEST(Bench, PrintsTablesForEachScene) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run =
      run_pelt(folder, {"bench", "scene.json", "scene.json", "--repeat", "1", "--frames", "5:6"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<std::string> lines = lines_of(run.out);
  const auto count = [&](const std::string& begin) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.rfind(begin, 0) == 0; });
  };
  EXPECT_EQ(count("scene.json: "), 2);
  EXPECT_EQ(count("query "), 8);
  EXPECT_EQ(count("on_demand "), 12);  // four tables of times and two lines of work for each scene
  EXPECT_EQ(count("all "), 2);         // vertices skinned
  for (const char* words : {"in contact", "update", "posed vertices", "by every", "vs paper",
                            "vs eager", "bytes per triangle", "ns per vertex"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(run.out.find("of rigid"), std::string::npos) << "pelt-lab has that method";
}

TEST(Bench, SaysThatFewRepetitionsAreARoughLook) {
  const TestFolder folder;
  write_limbs(folder);
  const auto is_rough = [&](const char* repetitions) {
    const Ended run = run_pelt(folder, {"bench", "scene.json", "--methods", "on_demand", "--frames",
                                        "5:6", "--repeat", repetitions});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out.find("rough measurement") != std::string::npos;
  };
  EXPECT_TRUE(is_rough("1"));
  EXPECT_TRUE(is_rough("8"));
  EXPECT_FALSE(is_rough("9"));
}

}  // namespace
}  // namespace pelt::test
