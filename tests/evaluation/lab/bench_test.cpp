/// `pelt-lab bench`: the modes that `pelt bench` does not have.

#include "tools/test_scenes.hpp"

#include <functional>
#include <iterator>
#include <regex>
#include <set>

namespace pelt::test {
namespace {

Ended bench(const TestFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"bench", "scene.json", "--repeat", "1"});
  return run_pelt(folder, words);
}

json figures(const TestFolder& folder, std::vector<std::string> options) {
  options.insert(options.end(), {"--json", "a.json"});
  const Ended run = bench(folder, options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(read_text(folder / "a.json"));
}

std::set<std::string> methods_in(const json& file) {
  std::set<std::string> names;
  for (const json& method : file["scenes"][0]["methods"]) names.insert(method["method"]);
  return names;
}

struct Refusal {
  std::vector<std::string> options;
  std::string message;
};

void expect_refused(const TestFolder& folder, const std::vector<Refusal>& refusals) {
  for (const auto& [options, message] : refusals) {
    const Ended run = bench(folder, options);
    EXPECT_EQ(run.exit_code, 2) << message;
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

// --- frames

TEST(LabBench, MeasuresHotAndColdCaches) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {});
  std::set<json> variants;
  for (const json& method : file["scenes"][0]["methods"])
    variants.insert(json::array({method["query"], method["cache"]}));
  EXPECT_EQ(variants,
            (std::set<json>{{"all", "hot"}, {"all", "cold"}, {"first", "hot"}, {"first", "cold"}}));
  EXPECT_EQ(methods_in(file),
            (std::set<std::string>{"eager", "on_demand", "paper", "paper_eager", "rigid"}));
  // The update of rigid bodies counts neither as their time nor as their work.
  for (const json& method : file["scenes"][0]["methods"]) {
    if (method["method"] != "rigid") continue;
    EXPECT_EQ(method["counters"]["posed_vertices"], 0);
    EXPECT_EQ(method["counters"]["refits"], 0);
    EXPECT_LE(method["mean_update_us"], method["mean_us"]);
  }
}

TEST(LabBench, MeasuresACharacterAgainstItself) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--self", "--frames", "0:3", "--caches", "hot"});
  EXPECT_EQ(file["scenes"][0]["scene"], "scene.json --self");
  EXPECT_EQ(methods_in(file), (std::set<std::string>{"boxes", "eager", "self"}));
}

// --- the comparison with an earlier run

/// Options of a quick run, and those given.
std::vector<std::string> quick(std::vector<std::string> options) {
  options.insert(options.begin(), {"--methods", "paper,eager,on_demand", "--frames", "4:7",
                                   "--caches", "hot", "--queries", "all"});
  return options;
}

/// Writes old.json, with the values of some rows replaced.
void write_old(const TestFolder& folder, const std::vector<std::string>& options,
               const std::function<void(json& method)>& change) {
  json file = figures(folder, options);
  for (json& method : file["scenes"][0]["methods"]) change(method);
  write_text(folder / "old.json", file.dump());
}

/// In the file, on demand takes a billionth of its real time.
TEST(LabAgainst, MarksWhatIsSlowerButDoesNotFail) {
  const TestFolder folder;
  write_limbs(folder);
  write_old(folder, quick({}), [](json& method) {
    if (method["method"] == "on_demand") method["mean_us"] = 1e-9 * double(method["mean_us"]);
  });
  const Ended run = bench(folder, quick({"--against", "old.json", "--margin", "1000"}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("against old.json: "), std::string::npos);
  EXPECT_NE(run.out.find("2 of 3 ratios worse by more than 1000 %"), std::string::npos) << run.out;
  const Ended same = bench(folder, quick({"--against", "a.json"}));
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("of 3 ratios worse by more than 15 %"), std::string::npos) << same.out;
}

TEST(LabAgainst, ADifferentAnswerIsAFailure) {
  const TestFolder folder;
  write_limbs(folder);
  write_old(folder, quick({}), [](json& method) { method["hash"] = "0123456789abcdef"; });
  const Ended run = bench(folder, quick({"--against", "old.json", "--json", "new.json"}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("different answers: hash 0123456789abcdef then"), std::string::npos);
  EXPECT_EQ(run.err.find("pelt-lab: error: 1 answer different from old.json"), 0u) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "new.json")) << "what was measured is not lost";
}

TEST(LabAgainst, KeepsItsFile) {
  const TestFolder folder;
  write_limbs(folder);
  const json old = figures(folder, quick({}));
  const Ended run = bench(folder, quick({"--against", "a.json", "--json", "a.json"}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--json: a.json is what --against"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("name another file"), std::string::npos) << run.err;
  EXPECT_EQ(json::parse(read_text(folder / "a.json")), old);
}

TEST(LabAgainst, ComparesSelfCollision) {
  const TestFolder folder;
  write_limbs(folder);
  const std::vector<std::string> options = {"--self",   "--frames",  "0:3",
                                            "--caches", "hot",       "--queries",
                                            "all",      "--methods", "boxes,self"};
  figures(folder, options);
  std::vector<std::string> again = options;
  again.insert(again.end(), {"--against", "a.json", "--margin", "1000"});
  const Ended same = bench(folder, again);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("of 1 ratio worse by more than 1000 %"), std::string::npos) << same.out;
  EXPECT_EQ(same.out.find("vs paper"), std::string::npos);
  EXPECT_EQ(same.out.find("a.json has no"), std::string::npos) << same.out;
}

TEST(LabAgainst, RefusesOtherFiles) {
  const TestFolder folder;
  write_limbs(folder);
  write_text(folder / "broken.json", "{");
  write_text(folder / "moving.json", R"({"format": "pelt-bench-moving"})");
  write_text(folder / "frames.json", R"({"format": "pelt-bench"})");
  expect_refused(
      folder,
      {{{"--margin", "9"}, "--margin: requires --against: name the file with --against FILE"},
       {{"--caches", "warm"}, "--caches: unknown value \"warm\""},
       {{"--against", "none.json"}, "none.json: "},
       {{"--against", "broken.json"}, "broken.json: the JSON text"},
       {{"--against", "scene.json"}, "scene.json: format: must be pelt-bench: give a file"},
       {{"--against", "moving.json"},
        "moving.json: format: must be pelt-bench, not pelt-bench-moving: give a file written by "
        "pelt bench --json"},
       {{"--moving", "--against", "frames.json"},
        "frames.json: format: must be pelt-bench-moving, not pelt-bench: give a file written by "
        "pelt-lab bench --moving --json"}});
}

/// Names with control characters, in a scene and of files, do not reach the terminal.
TEST(LabAgainst, PrintsHarmlessNames) {
  const TestFolder folder;
  write_limbs(folder);
  const std::string old = "a\x1b[2J\nb.json";
  const auto is_harmless = [](const Ended& run) {
    return (run.out + run.err).find('\x1b') == std::string::npos;
  };
  EXPECT_TRUE(is_harmless(bench(folder, quick({"--against", old}))));
  json file = figures(folder, quick({}));
  for (json& method : file["scenes"][0]["methods"]) method["hash"] = "0123456789abcdef";
  file["machine"]["cpu"] = "x\x1b[2J";
  write_text(folder / old, file.dump());
  const Ended run = bench(folder, quick({"--against", old}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(is_harmless(run)) << run.out << run.err;
}

// --- steps between frames

TEST(LabMoving, WritesFiguresOfEveryQuery) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--moving", "--methods", "brute,eager,on_demand"});
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
  // The discrete contacts at the ends of the steps.
  const Ended check = run_pelt(folder, {"check", "scene.json", "--frames", "1:12"});
  EXPECT_NE(check.out.find(methods[0]["hash"].get<std::string>()), std::string::npos) << check.out;
}

TEST(LabMoving, MeasuresUnitedBoxesAndPrintsRatios) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run = bench(folder, {"--moving", "--json", "a.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* words : {"11 steps between frames", "of collide", "of on_demand", "ns per pair"})
    EXPECT_NE(run.out.find(words), std::string::npos) << run.out;
  EXPECT_EQ(methods_in(json::parse(read_text(folder / "a.json"))),
            (std::set<std::string>{"eager", "on_demand", "united"}));
}

TEST(LabMoving, RatiosAreEmptyWithoutOnDemand) {
  const TestFolder folder;
  write_limbs(folder);
  const json file = figures(folder, {"--moving", "--methods", "eager", "--frames", "0:12:3"});
  EXPECT_EQ(file["scenes"][0]["steps"], 4);
  for (const json& method : file["scenes"][0]["methods"])
    EXPECT_TRUE(method["of_collide"].is_null());
}

/// In the file, on demand takes a billionth of its real time in the steps.
TEST(LabMoving, ComparesWithWhatJsonWrote) {
  const TestFolder folder;
  write_limbs(folder);
  const std::vector<std::string> options = {"--moving", "--methods", "eager,on_demand"};
  write_old(folder, options, [](json& method) {
    if (method["method"] == "on_demand" && method["query"] != "collide")
      method["mean_us"] = 1e-9 * double(method["mean_us"]);
  });
  const auto against = [&](std::vector<std::string> more) {
    more.insert(more.begin(), options.begin(), options.end());
    more.insert(more.end(), {"--against", "old.json"});
    return bench(folder, more);
  };
  const Ended run = against({"--margin", "1000"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("4 of 14 ratios worse by more than 1000 %"), std::string::npos) << run.out;
  write_old(folder, options, [](json& method) {
    if (method["query"] == "times") method["hash"] = "0123456789abcdef";
  });
  const Ended other = against({});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_NE(other.out.find("query times: different answers: hash 0123456789abcdef then"),
            std::string::npos)
      << other.out;
  EXPECT_NE(other.err.find("1 answer different from old.json"), std::string::npos) << other.err;
}

// --- searches that are stopped

TEST(LabAnytime, WritesFiguresAndAChart) {
  const TestFolder folder;
  write_limbs(folder);
  const Ended run = bench(folder, {"--anytime", "--json", "a.json", "--svg", "a.svg"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* words :
       {"contacts listed [%] after a share of the method's own work", "longest step"})
    EXPECT_NE(run.out.find(words), std::string::npos) << run.out;
  const json file = json::parse(read_text(folder / "a.json"));
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
  EXPECT_EQ(read_text(folder / "a.svg").find("<svg xmlns="), 0u);
  const Ended check = run_pelt(folder, {"check", "scene.json"});
  EXPECT_NE(check.out.find(scene["hash"].get<std::string>()), std::string::npos) << check.out;
}

TEST(LabAnytime, MeasuresOnlyChosenMethodsAndFrames) {
  const TestFolder folder;
  write_limbs(folder);
  const json file =
      figures(folder, {"--anytime", "--methods", "resolution,contacts", "--frames", "5:7"});
  EXPECT_EQ(file["scenes"][0]["pairs"], 2);
  ASSERT_EQ(file["scenes"][0]["methods"].size(), 2u);
  EXPECT_EQ(file["scenes"][0]["methods"][1]["over_work"][6]["time"], 1);
}

// --- options, help and documents

TEST(LabBench, RefusesOptionsWithoutMeaning) {
  const TestFolder folder;
  write_limbs(folder);
  std::vector<Refusal> refusals;
  const std::vector<std::vector<std::string>> without_meaning = {
      {"--self"}, {"--queries", "all"}, {"--caches", "hot"}, {"--threads", "2"}};
  const auto refuse = [&](const std::string& mode, std::vector<std::string> options) {
    refusals.push_back({options, mode + ": cannot be combined with " + options[0]});
    refusals.back().options.push_back(mode);
  };
  for (const auto& options : without_meaning) {
    refuse("--moving", options);
    refuse("--anytime", options);
  }
  for (const auto& options : std::vector<std::vector<std::string>>{
           {"--moving"}, {"--against", "a.json"}, {"--margin", "3"}})
    refuse("--anytime", options);
  expect_refused(folder, refusals);
  expect_refused(
      folder, {{{"--svg", "a.svg"}, "--svg: requires --anytime"},
               {{"--moving", "--margin", "3"}, "--margin: requires --against"},
               {{"--moving", "--methods", "on_demnd"}, "did you mean \"on_demand\"?"},
               {{"--anytime", "--methods", "paper"}, "--methods: the method contacts is missing"},
               {{"--anytime", "--methods", "contact"}, "did you mean \"contacts\"?"},
               {{"--anytime", "--frames", "0:1"}, "scene.json: has no contact in 1 frame"},
               {{"--anytime", "--frames", "0:13"}, "--frames: 13 goes beyond the last frame"},
               {{"--anytime", "--svg", "one.glb"}, "--svg: one.glb is "},
               {{"--anytime", "--svg", "a", "--json", "a"}, "--svg"}});
  for (const std::string mode : {"--moving", "--anytime"}) {
    const Ended model = run_pelt(folder, {"bench", "one.glb", mode});
    EXPECT_EQ(model.exit_code, 2);
    EXPECT_NE(model.err.find(mode + ": requires scene files"), std::string::npos) << model.err;
  }
}

TEST(LabBench, ExamplesOfTheHelpRun) {
  const TestFolder folder;
  // A scene with the frames that the examples use, some of them in contact.
  std::string scene = kLimbsScene;
  scene.replace(scene.find("\"count\": 12, \"fps\": 6"), 21, "\"count\": 60, \"fps\": 30");
  write_limbs(folder);
  write_text(folder / "scene.json", scene);
  GltfBuilder knight = build_limb(20);
  knight.document["animations"][0]["name"] = "Walk";
  write_bytes(folder / "knight.glb", knight.glb());
  std::size_t examples = 0;
  for (const std::string& line : lines_of(run_pelt(folder, {"bench", "--help"}).out)) {
    if (line.rfind("  pelt-lab ", 0) != 0) continue;
    std::istringstream stream(line.substr(11));
    std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    words.insert(words.end(), {"--repeat", "1"});
    const Ended run = run_pelt(folder, words);
    EXPECT_EQ(run.exit_code, 0) << line << "\n" << run.err;
    ++examples;
  }
  EXPECT_GE(examples, 5u);
}

/// Collects the paths of numbers, texts and nulls: "scenes[].methods[].mean_us".
void collect_paths(const json& value, const std::string& path, std::set<std::string>& paths) {
  if (value.is_array()) {
    for (const json& element : value) collect_paths(element, path + "[]", paths);
  } else if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      collect_paths(member, path.empty() ? key : path + "." + key, paths);
  } else {
    paths.insert(path);
  }
}

/// The fields that the table below a heading of evaluation/README.md describes.
std::set<std::string> described_below(const std::string& heading) {
  const std::string page = read_text(PELT_EVALUATION_DIR "/README.md");
  const std::size_t begin = page.find("### " + heading), end = page.find("\n#", begin + 1);
  const std::string section = page.substr(begin, end - begin);
  const std::regex row("\n\\| `([^`]+)` \\|");
  std::set<std::string> fields;
  for (std::sregex_iterator match(section.begin(), section.end(), row), none; match != none;
       ++match)
    EXPECT_TRUE(fields.insert((*match)[1]).second) << (*match)[1] << " is described twice";
  return fields;
}

TEST(LabBench, ReadmeDescribesEveryFieldAndNoOther) {
  const TestFolder folder;
  write_limbs(folder);
  std::set<std::string> moving, anytime;
  collect_paths(figures(folder, {"--moving", "--frames", "4:6"}), "", moving);
  collect_paths(figures(folder, {"--anytime", "--frames", "5:6"}), "", anytime);
  EXPECT_EQ(described_below("Figures of steps"), moving);
  EXPECT_EQ(described_below("Figures of searches"), anytime);
}

}  // namespace
}  // namespace pelt::test
