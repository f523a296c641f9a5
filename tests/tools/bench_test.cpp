#include "tools/test_scenes.hpp"

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
  const json file = figures(
      folder, {"--methods", "paper,paper_eq2,paper_eager,paper_rigid", "--frames", "2:11:2"});
  EXPECT_EQ(file["format"], "pelt-bench");
  EXPECT_EQ(file["version"], 1);
  EXPECT_TRUE(file["machine"].contains("cpu"));
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "scene.json");
  EXPECT_EQ(scene["frames"], 5);
  EXPECT_GT(scene["frames_in_contact"], 0);
  ASSERT_EQ(scene["engines"].size(), 4u);
  for (const json& engine : scene["engines"]) {
    EXPECT_EQ(engine["query"], "all");
    EXPECT_EQ(engine["cache"], "hot");
    EXPECT_EQ(engine["threads"], 1);
    EXPECT_GT(engine["mean_us"], engine["mean_update_us"]);
    EXPECT_GT(engine["mean_contact_us"], 0);
    EXPECT_GE(engine["p95_us"], engine["mean_update_us"]);
    EXPECT_EQ(engine["hash"], scene["engines"][0]["hash"]);
  }
  EXPECT_EQ(scene["engines"][2]["engine"], "paper_eager");
}

TEST(Bench, HashIsThatOfCheck) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "paper"});
  const Ended check = run_pelt(folder, {"check", "scene.json"});
  EXPECT_NE(check.out.find(file["scenes"][0]["engines"][0]["hash"].get<std::string>()),
            std::string::npos);
}

TEST(Bench, FirstAsksLess) {
  const TestFolder folder;
  write_limbs(folder);
  const json all = figures(folder, {"--methods", "paper"});
  const json first = figures(folder, {"--methods", "paper_eager,paper", "--first"});
  const json& engines = first["scenes"][0]["engines"];
  EXPECT_EQ(engines[1]["query"], "first");
  EXPECT_EQ(engines[0]["hash"], engines[1]["hash"]);
  EXPECT_NE(engines[1]["hash"], all["scenes"][0]["engines"][0]["hash"]);
  EXPECT_LT(engines[1]["counters"]["triangle_pairs"],
            all["scenes"][0]["engines"][0]["counters"]["triangle_pairs"]);
}

TEST(Bench, ColdCacheAndFramesWithoutContact) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--methods", "paper", "--cache", "cold", "--frames", "0:1"});
  const json& engine = file["scenes"][0]["engines"][0];
  EXPECT_EQ(engine["cache"], "cold");
  EXPECT_EQ(engine["mean_contact_us"], json());
}

TEST(Bench, PrintsATableForEachScene) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run =
      run_pelt(folder, {"bench", "scene.json", "scene.json", "--repeat", "1", "--frames", "5:6"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<std::string> lines = lines_of(run.out);
  const auto starts = [](const std::string& line) { return line.rfind("scene.json: ", 0) == 0; };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), starts), 2);
  for (const char* words : {"paper_eager", "in contact", "update", "posed vertices", "by every"}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace pelt::test
