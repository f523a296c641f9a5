/// Compares the answer of `pelt check` with all pairs of triangles.

#include "tools/answer.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/test_scenes.hpp"

#include <map>

namespace pelt::test {
namespace {

Result<scenes::Scene> load(const std::string& path) { return scenes::load_scene(path); }

TEST(CheckAnswer, EqualsBruteForceInEveryFrame) {
  const TestFolder folder;
  const auto scene = load(write_limbs(folder));
  ASSERT_TRUE(scene) << scene.error().message;
  const Ended run = run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "a.jsonl", "--pairs"});
  const CheckFile file = parse_check_file(read_text(folder / "a.jsonl"));
  ASSERT_EQ(file.frames.size(), 12u);
  std::uint64_t contacts = 0, frames_in_contact = 0;
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    const auto posed = tools::scene::pose_instances(*scene, frame, {});
    ASSERT_TRUE(posed);
    const json expected = brute_force_json((*posed)[0], (*posed)[1]);
    json line = {{"frame", frame}, {"time", frame / 6.0}, {"contacts", expected.size()}};
    line["pairs"] = json::array();
    if (!expected.empty()) {
      line["pairs"].push_back(
          {{"a", 0}, {"b", 1}, {"contacts", expected.size()}, {"triangles", expected}});
    }
    EXPECT_EQ(file.frames[frame], line);
    contacts += expected.size();
    frames_in_contact += !expected.empty();
  }
  // The test is meaningful only if the scene has frames with and without contact.
  EXPECT_GT(frames_in_contact, 2u);
  EXPECT_LT(frames_in_contact, 12u);
  EXPECT_GT(contacts, 100u);
  EXPECT_EQ(file.totals["totals"], json({{"frames", 12},
                                         {"frames_in_contact", frames_in_contact},
                                         {"contacts", contacts},
                                         {"ignored", 0}}));
  EXPECT_EQ(file.totals["hash"], hash_of(file));
  EXPECT_TRUE(contains(run.out, hash_of(file)));
}

TEST(CheckAnswer, HeaderHasInputsAndOptions) {
  const LimbsFolder folder;
  const Ended run = run_pelt(folder, {"check", "scene.json", "--frames", "5:8", "--jsonl", "-"});
  const json header = parse_check_file(run.out).header;
  EXPECT_EQ(header["format"], "pelt-check");
  EXPECT_EQ(header["version"], 1);
  EXPECT_EQ(header["pelt"], "0.1.0");
  EXPECT_EQ(header["inputs"][1]["path"], "two.glb");
  EXPECT_EQ(header["inputs"][1]["hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(header["instances"], json::parse(R"([{"index": 0, "model": "one", "triangles": 1148},
                            {"index": 1, "model": "two", "triangles": 956}])"));
  EXPECT_EQ(header["options"]["frames"], json({5, 8, 1}));
  EXPECT_EQ(header["options"]["method"], "on_demand");
  EXPECT_EQ(header["options"]["by"], "instance");
  EXPECT_EQ(header["options"]["max_contacts"], json());
  EXPECT_EQ(header["options"]["pairs"], false);
}

TEST(CheckAnswer, IsTheSameByEveryMethod) {
  const LimbsFolder folder;
  std::vector<json> frames;
  std::map<std::string, json> counters;
  for (const std::string_view name : methods::names_of(methods::kCommandMethods)) {
    const std::string method(name);
    const CheckFile file =
        answer_of(folder, 1, {"check", "scene.json", "--method", method, "--pairs"});
    EXPECT_EQ(file.header["options"]["method"], method);
    frames.push_back({file.frames, file.totals["hash"], file.totals["totals"]});
    counters[method] = file.totals["counters"];
    EXPECT_EQ(frames.back(), frames.front()) << method;
  }
  // Eager poses every vertex; on demand poses far fewer.
  const json &lazy = counters["on_demand"], &eager = counters["eager"];
  EXPECT_LT(lazy["posed_vertices"], eager["posed_vertices"]);
  EXPECT_LT(lazy["refits"], eager["refits"]);
  EXPECT_EQ(counters["brute"]["refits"], 0);
}

TEST(CheckAnswer, TwoRunsWriteTheSameBytes) {
  const LimbsFolder folder;
  for (const char* name : {"a", "b"}) run_pelt(folder, {"check", "scene.json", "--jsonl", name});
  EXPECT_EQ(read_text(folder / "a"), read_text(folder / "b"));
}

TEST(CheckAnswer, LimitsCutShort) {
  const LimbsFolder folder;
  const Ended whole = run_pelt(folder, {"check", "scene.json", "--jsonl", "-"});
  const std::vector<std::pair<std::vector<std::string>, std::uint64_t>> limits = {
      {{"--first"}, 1}, {{"--max-contacts", "1"}, 1}, {{"--max-contacts", "7"}, 7}};
  for (const auto& limit : limits) {
    const CheckFile file = answer_of(folder, 1, joined({"check", "scene.json"}, limit.first)),
                    all = parse_check_file(whole.out);
    EXPECT_EQ(file.totals["hash"], json());
    EXPECT_EQ(file.totals["cut_short"], true);
    EXPECT_EQ(file.header["options"]["max_contacts"], limit.second);
    for (std::size_t f = 0; f < file.frames.size(); ++f) {
      const auto most = std::min(limit.second, all.frames[f]["contacts"].get<std::uint64_t>());
      EXPECT_EQ(file.frames[f]["contacts"], most);
    }
  }
}

TEST(CheckAnswer, ByPartTestsPartsOfOneInstance) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  const CheckFile file = answer_of(folder, 1,
                                   {"check", strip, strip, "--at", "0,0,0", "--at", "0.25,0.1,0.05",
                                    "--clip", "bend", "--fps", "4", "--by", "part", "--pairs"});
  EXPECT_EQ(file.header["instances"], json::parse(R"([
    {"index": 0, "model": "strip", "triangles": 6, "instance": 0, "part": "paper", "first_triangle": 0},
    {"index": 1, "model": "strip", "triangles": 2, "instance": 0, "part": "fan", "first_triangle": 6},
    {"index": 2, "model": "strip", "triangles": 6, "instance": 1, "part": "paper", "first_triangle": 0},
    {"index": 3, "model": "strip", "triangles": 2, "instance": 1, "part": "fan", "first_triangle": 6}])"));

  const auto character = scenes::load_character(strip);
  ASSERT_TRUE(character) << character.error().message;
  scenes::Scene scene;
  scene.fps = 4;
  scene.characters.push_back(*character);
  scene.instances.resize(2);
  scene.instances[0].clip = "bend";
  scene.instances[1].translation = {0.25, 0.1, 0.05};
  bool met_within = false, met_between = false;
  for (std::uint32_t frame = 0; frame < file.frames.size(); ++frame) {
    const auto posed = tools::scene::pose_instances(scene, frame, {});
    ASSERT_TRUE(posed);
    // The triangles of each part as a model; triangle numbers in answers refer to the whole model.
    std::vector<tools::scene::PosedInstance> parts;
    for (const tools::scene::PosedInstance& instance : *posed) {
      for (const auto& part : character->asset.parts) {
        parts.push_back(instance);
        parts.back().triangles =
            instance.triangles.subspan(part.first_triangle, part.triangle_count);
      }
    }
    json expected = json::array();
    for (std::uint32_t a = 0; a < 4; ++a) {
      for (std::uint32_t b = a + 1; b < 4; ++b) {
        json triangles = brute_force_json(parts[a], parts[b]);
        for (json& pair : triangles) {
          pair = {pair[0].get<int>() + 6 * static_cast<int>(a % 2),
                  pair[1].get<int>() + 6 * static_cast<int>(b % 2)};
        }
        if (triangles.empty()) continue;
        (a / 2 == b / 2 ? met_within : met_between) = true;
        expected.push_back(
            {{"a", a}, {"b", b}, {"contacts", triangles.size()}, {"triangles", triangles}});
      }
    }
    EXPECT_EQ(file.frames[frame]["pairs"], expected) << "frame " << frame;
  }
  EXPECT_TRUE(met_within);
  EXPECT_TRUE(met_between);
  EXPECT_EQ(file.totals["hash"], hash_of(file));
}

}  // namespace
}  // namespace pelt::test
