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
                                                  {"--threads", "2"}}) {
    const Ended run = bench_moving(folder, options);
    EXPECT_EQ(run.exit_code, 2) << options[0];
    EXPECT_NE(run.err.find("--moving: cannot be combined with " + options[0]), std::string::npos)
        << run.err;
  }
  const Ended margin = bench_moving(folder, {"--margin", "3"});
  EXPECT_NE(margin.err.find("--margin: requires --against"), std::string::npos) << margin.err;
  const Ended model = run_pelt(folder, {"bench", "one.glb", "--moving"});
  EXPECT_EQ(model.exit_code, 2);
  EXPECT_NE(model.err.find("--moving: requires scene files"), std::string::npos) << model.err;
  const Ended method = bench_moving(folder, {"--methods", "on_demnd"});
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_NE(method.err.find("did you mean \"on_demand\"?"), std::string::npos) << method.err;
}

/// In the file, on demand takes a billionth of its real time in the steps.
TEST(BenchMovingCommand, ComparesWithWhatJsonWrote) {
  const TestFolder folder;
  write_limbs(folder);
  ASSERT_EQ(bench_moving(folder, {"--json", "old.json"}).exit_code, 0);
  json file = json::parse(read_text(folder / "old.json"));
  for (json& method : file["scenes"][0]["methods"])
    if (method["method"] == "on_demand" && method["query"] != "collide")
      method["mean_us"] = 1e-9 * double(method["mean_us"]);
  write_text(folder / "old.json", file.dump());
  const Ended run = bench_moving(folder, {"--against", "old.json", "--margin", "1000"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("against old.json: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("4 of 14 ratios worse by more than 1000 %"), std::string::npos) << run.out;
}

TEST(BenchMovingCommand, AnotherAnswerOrAnotherKindOfFileIsAFailure) {
  const TestFolder folder;
  write_limbs(folder);
  ASSERT_EQ(bench_moving(folder, {"--json", "old.json"}).exit_code, 0);
  json file = json::parse(read_text(folder / "old.json"));
  for (json& method : file["scenes"][0]["methods"])
    if (method["query"] == "times") method["hash"] = "0123456789abcdef";
  write_text(folder / "old.json", file.dump());
  const Ended other = bench_moving(folder, {"--against", "old.json"});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_NE(other.out.find("query times: different answers: hash 0123456789abcdef then"),
            std::string::npos)
      << other.out;
  EXPECT_NE(other.err.find("1 answer different from old.json"), std::string::npos) << other.err;
  const Ended scene = run_pelt(folder, {"bench", "scene.json", "--against", "old.json"});
  EXPECT_EQ(scene.exit_code, 2);
  EXPECT_NE(scene.err.find("old.json: format: must be pelt-bench, not pelt-bench-moving: give a "
                           "file written by pelt bench --json"),
            std::string::npos)
      << scene.err;
  file["format"] = "pelt-bench";
  write_text(folder / "old.json", file.dump());
  const Ended moving = bench_moving(folder, {"--against", "old.json"});
  EXPECT_EQ(moving.exit_code, 2);
  EXPECT_NE(moving.err.find("old.json: format: must be pelt-bench-moving, not pelt-bench: give a "
                            "file written by pelt bench --moving --json"),
            std::string::npos)
      << moving.err;
}

}  // namespace
}  // namespace pelt::test
