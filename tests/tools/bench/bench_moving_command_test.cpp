/// `pelt bench --moving`.

#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

Ended bench_moving(const TestFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {"bench", "scene.json", "--moving", "--repeat", "1"});
  return run_pelt(folder, options);
}

TEST(BenchMovingCommand, WritesFiguresOfEveryQuery) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run =
      bench_moving(folder, {"--methods", "brute,eager,on_demand", "--json", "moving.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("11 steps between frames"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("of collide"), std::string::npos) << run.out;
  const json file = json::parse(read_text(folder / "moving.json"));
  EXPECT_EQ(file["format"], "pelt-bench-moving");
  EXPECT_EQ(file["version"], 1);
  EXPECT_TRUE(file["machine"].contains("cpu"));
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "scene.json");
  EXPECT_EQ(scene["steps"], 11);
  EXPECT_GT(scene["skinning"]["mean_us"], 0);
  const json& methods = scene["methods"];
  ASSERT_EQ(methods.size(), 15u);
  const char* queries[] = {"collide", "pairs", "times", "first", "touch"};
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(methods[i]["query"], queries[i / 3]);
    EXPECT_EQ(methods[i]["hash"], methods[i - i % 3]["hash"]);
    EXPECT_GT(methods[i]["median_us"], 0);
    EXPECT_GT(methods[i]["of_collide"], 0);
    EXPECT_EQ(methods[i]["ns_per_pair"].is_null(), i / 3 == 0 || i / 3 > 2);
    EXPECT_TRUE(methods[i]["counters"].contains("exact_pairs"));
  }
  EXPECT_GT(methods[3]["contacts"], methods[0]["contacts"]) << "steps have more than their ends";
  EXPECT_EQ(methods[3]["contacts"], methods[6]["contacts"]);
}

TEST(BenchMovingCommand, RatiosAreEmptyWithoutOnDemand) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run =
      bench_moving(folder, {"--methods", "eager", "--frames", "0:12:3", "--json", "moving.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json file = json::parse(read_text(folder / "moving.json"));
  EXPECT_EQ(file["scenes"][0]["steps"], 4);
  for (const json& method : file["scenes"][0]["methods"])
    EXPECT_TRUE(method["of_collide"].is_null());
}

/// Discrete contacts at the ends of the steps.
TEST(BenchMovingCommand, HashOfCollideIsThatOfCheck) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run = bench_moving(folder, {"--json", "moving.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json file = json::parse(read_text(folder / "moving.json"));
  const Ended check = run_pelt(folder, {"check", "scene.json", "--frames", "1:12"});
  EXPECT_NE(check.out.find(file["scenes"][0]["methods"][0]["hash"].get<std::string>()),
            std::string::npos)
      << check.out;
}

TEST(BenchMovingCommand, RefusesOptionsWithoutMeaning) {
  const TestFolder folder;
  write_limbs(folder);
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--self"},
                                                  {"--queries", "all"},
                                                  {"--caches", "hot"},
                                                  {"--threads", "2"},
                                                  {"--against", "a.json"},
                                                  {"--margin", "3"}}) {
    const Ended run = bench_moving(folder, options);
    EXPECT_EQ(run.exit_code, 2) << options[0];
    EXPECT_NE(run.err.find("--moving: cannot be combined with " + options[0]), std::string::npos)
        << run.err;
  }
  const Ended model = run_pelt(folder, {"bench", "one.glb", "--moving"});
  EXPECT_EQ(model.exit_code, 2);
  EXPECT_NE(model.err.find("--moving: requires scene files"), std::string::npos) << model.err;
  const Ended method = bench_moving(folder, {"--methods", "on_demnd"});
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_NE(method.err.find("did you mean \"on_demand\"?"), std::string::npos) << method.err;
}

}  // namespace
}  // namespace pelt::test
