/// `pelt bench` of characters against themselves.

#include "tools/test_scenes.hpp"

#include <iterator>

namespace pelt::test {
namespace {

Ended bench_self(const TestFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"bench", "--repeat", "1", "--caches", "hot", "--frames", "0:3"});
  return run_pelt(folder, words);
}

json self_figures(const TestFolder& folder, std::vector<std::string> words) {
  words.insert(words.end(), {"--json", "a.json"});
  const Ended run = bench_self(folder, words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(read_text(folder / "a.json"));
}

TEST(BenchSelf, MeasuresAModelAgainstItself) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
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
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const json file = self_figures(folder, {"strip.glb", "--clip", "bend"});
  const Ended check =
      run_pelt(folder, {"check", "strip.glb", "--clip", "bend", "--frames", "0:3", "--self-rings",
                        "0", "--self-at-rest", "keep", "--self-near-joints", "keep"});
  EXPECT_EQ(check.exit_code, 1) << check.err;
  EXPECT_NE(check.out.find(file["scenes"][0]["methods"][0]["hash"].get<std::string>()),
            std::string::npos)
      << check.out;
}

/// The words of the rows of `method` in all tables of times.
std::vector<std::vector<std::string>> rows_of(const std::string& text, const std::string& method) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(text)) {
    std::istringstream stream(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (words.size() > 6 && words[0] == method && words[1] == "1") rows.push_back(words);
  }
  return rows;
}

TEST(BenchSelf, PrintsCostsOverBoxes) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const Ended run = bench_self(folder, {"strip.glb", "--clip", "bend"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* words : {"self filters: built in ", "of boxes", "vs all", "by every method",
                            "frames in order, all contacts: self "})
    EXPECT_NE(run.out.find(words), std::string::npos) << words;
  for (const char* words : {"vs paper", "vs eager", "vs 1 thread", "of rigid"})
    EXPECT_EQ(run.out.find(words), std::string::npos) << words;
  const auto boxes = rows_of(run.out, "boxes"), self = rows_of(run.out, "self");
  ASSERT_EQ(boxes.size(), 2u);
  ASSERT_EQ(self.size(), 2u);
  EXPECT_EQ(boxes[0].back(), "1.00");
  EXPECT_GT(std::stod(self[0].back()), 0);
  EXPECT_EQ(self[1].size(), self[0].size() + 1) << "only first contacts are compared with all";
}

TEST(BenchSelf, PlaysTheClipAtTheChosenRate) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const auto frames = [&](const char* fps) {
    const Ended run = run_pelt(folder, {"bench", "strip.glb", "--clip", "bend", "--repeat", "1",
                                        "--caches", "hot", "--fps", fps, "--json", "fps.json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(read_text(folder / "fps.json"))["scenes"][0]["frames"].get<int>();
  };
  EXPECT_EQ(frames("60"), 2 * frames("30"));
}

TEST(BenchSelf, MeasuresEachInstanceOfAScene) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = self_figures(folder, {"scene.json", "--self"});
  const json& scene = file["scenes"][0];
  EXPECT_EQ(scene["scene"], "scene.json --self");
  ASSERT_EQ(scene["methods"].size(), 4u);
  EXPECT_EQ(scene["methods"][1]["method"], "self");
  EXPECT_GT(scene["methods"][1]["counters"]["posed_vertices"], 0);
}

TEST(BenchSelf, ComparesWithAnEarlierRun) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  json file = self_figures(folder, {"strip.glb", "--clip", "bend"});
  const Ended same = bench_self(
      folder, {"strip.glb", "--clip", "bend", "--against", "a.json", "--margin", "1000"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("of 2 ratios worse by more than 1000 %"), std::string::npos) << same.out;
  EXPECT_EQ(same.out.find("vs paper"), std::string::npos);
  EXPECT_EQ(same.out.find("a.json has no"), std::string::npos) << same.out;
  for (json& method : file["scenes"][0]["methods"]) method["hash"] = "0123456789abcdef";
  write_text(folder / "a.json", file.dump());
  EXPECT_EQ(bench_self(folder, {"strip.glb", "--clip", "bend", "--against", "a.json"}).exit_code,
            3);
}

TEST(BenchSelf, RefusesWhatItCannotMeasure) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
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
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace pelt::test
