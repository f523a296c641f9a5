/// `pelt bench --anytime`.

#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

Ended bench_anytime(const TestFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {"bench", "scene.json", "--anytime", "--repeat", "1"});
  return run_pelt(folder, options);
}

TEST(BenchAnytimeCommand, WritesFiguresAndAChart) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run = bench_anytime(folder, {"--json", "anytime.json", "--svg", "anytime.svg"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("contacts listed [%] after a share of the method's own work"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("longest step"), std::string::npos) << run.out;
  const json file = json::parse(read_text(folder / "anytime.json"));
  EXPECT_EQ(file["format"], "pelt-bench-anytime");
  EXPECT_EQ(file["version"], 1);
  EXPECT_TRUE(file["machine"].contains("cpu"));
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "scene.json");
  EXPECT_GT(scene["pairs"], 1);
  EXPECT_GT(scene["collide_us"], 0);
  const char* names[] = {"contacts", "resolution", "first_contact", "paper"};
  ASSERT_EQ(scene["methods"].size(), 4u);
  for (std::size_t m = 0; m < 4; ++m) {
    const json& method = scene["methods"][m];
    EXPECT_EQ(method["method"], names[m]);
    ASSERT_EQ(method["over_work"].size(), 7u);
    EXPECT_EQ(method["over_work"][1]["share"], 0.02);
    EXPECT_EQ(method["over_work"][6]["listed"], 1);
    EXPECT_EQ(method["over_time"].size(), 7u);
    EXPECT_GT(method["area_over_work"], 0);
    EXPECT_GT(method["mean_us"], 0);
    EXPECT_GT(method["longest_step"], 0);
  }
  EXPECT_EQ(read_text(folder / "anytime.svg").find("<svg xmlns="), 0u);
  const Ended check = run_pelt(folder, {"check", "scene.json"});
  EXPECT_NE(check.out.find(scene["hash"].get<std::string>()), std::string::npos) << check.out;
}

TEST(BenchAnytimeCommand, MeasuresOnlyChosenMethodsAndFrames) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run = bench_anytime(
      folder, {"--methods", "resolution,contacts", "--frames", "5:7", "--json", "anytime.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json file = json::parse(read_text(folder / "anytime.json"));
  EXPECT_EQ(file["scenes"][0]["pairs"], 2);
  ASSERT_EQ(file["scenes"][0]["methods"].size(), 2u);
  EXPECT_EQ(file["scenes"][0]["methods"][1]["over_work"][6]["time"], 1);
}

TEST(BenchAnytimeCommand, RefusesOptionsWithoutMeaning) {
  const TestFolder folder;
  write_limbs(folder);
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--self"},
                                                  {"--moving"},
                                                  {"--queries", "all"},
                                                  {"--caches", "hot"},
                                                  {"--threads", "2"},
                                                  {"--against", "a.json"},
                                                  {"--margin", "3"}}) {
    const Ended run = bench_anytime(folder, options);
    EXPECT_EQ(run.exit_code, 2) << options[0];
    EXPECT_NE(run.err.find("--anytime: cannot be combined with " + options[0]), std::string::npos)
        << run.err;
  }
  const std::pair<std::vector<std::string>, const char*> refusals[] = {
      {{"--methods", "paper"}, "--methods: the method contacts is missing"},
      {{"--methods", "contact"}, "did you mean \"contacts\"?"},
      {{"--frames", "0:1"}, "scene.json: has no contact in 1 frame"},
      {{"--frames", "0:13"}, "--frames: 13 goes beyond the last frame"},
      {{"--svg", "one.glb"}, "--svg: one.glb is "},
      {{"--svg", "a", "--json", "a"}, "--svg"}};
  for (const auto& [options, message] : refusals) {
    const Ended run = bench_anytime(folder, options);
    EXPECT_EQ(run.exit_code, 2) << message;
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
  }
  const Ended model = run_pelt(folder, {"bench", "one.glb", "--anytime"});
  EXPECT_NE(model.err.find("--anytime: requires scene files"), std::string::npos) << model.err;
  const Ended chart = run_pelt(folder, {"bench", "scene.json", "--svg", "a.svg"});
  EXPECT_NE(chart.err.find("--svg: requires --anytime"), std::string::npos) << chart.err;
}

}  // namespace
}  // namespace pelt::test
