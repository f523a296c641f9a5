/// `pelt check` for a build server: ignored pairs, baselines, failures.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <algorithm>

namespace pelt::test {
namespace {

std::uint64_t contacts_of(const CheckFile& file) { return file.totals["totals"]["contacts"]; }

/// Moves one limb of the scene closer: places that touched then have more contacts.
void move_limb(const TestFolder& folder) {
  std::string text = read_text(folder / "scene.json");
  const std::string place = "[0.5, 0, 0.03]";
  ASSERT_TRUE(contains(text, place));
  write_text(folder / "scene.json", text.replace(text.find(place), place.size(), "[0.5, 0, 0.0]"));
}

TEST(CheckTouches, AddUpToAllContacts) {
  const LimbsFolder folder;
  const CheckFile file = check_pairs(folder, 1, {"scene.json"});
  std::uint64_t contacts = 0;
  for (const json& touch : file.totals["touches"]) {
    contacts += touch["contacts"].get<std::uint64_t>();
    EXPECT_LE(touch["worst"]["contacts"], touch["contacts"]);
    const json frame = file.frames[touch["worst"]["frame"].get<std::size_t>()];
    EXPECT_GE(frame["contacts"], touch["worst"]["contacts"]);
    EXPECT_EQ(touch["a"]["model"], "one");
    EXPECT_EQ(touch["b"]["instance"], 1);
  }
  EXPECT_GT(file.totals["touches"].size(), 2u);
  EXPECT_EQ(contacts, contacts_of(file));
}

TEST(CheckBaseline, OfTheSameSceneFindsNothingWorse) {
  const LimbsFolder folder;
  run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "known.jsonl"});
  const CheckFile file = check_pairs(folder, 0, {"scene.json", "--baseline", "known.jsonl"});
  const json none = json::array();
  EXPECT_EQ(file.totals["verdict"], json({{"fail_on", "grown"},
                                          {"failed", false},
                                          {"pairs_compared", 1},
                                          {"worse", none},
                                          {"gone", none},
                                          {"left_out", none},
                                          {"newly_held", none},
                                          {"no_longer_held", none},
                                          {"notes", none}}));
  EXPECT_GT(contacts_of(file), 0u);
}

TEST(CheckBaseline, ReportsWhatIsNewAndWhatHasGrown) {
  const LimbsFolder folder;
  run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "known.jsonl"});
  move_limb(folder);
  const CheckFile file = check_pairs(folder, 1, {"scene.json", "--baseline", "known.jsonl"});
  const CheckFile known = parse_check_file(read_text(folder / "known.jsonl"));
  const json worse = file.totals["verdict"]["worse"];
  std::size_t expected = 0;
  for (const json& touch : file.totals["touches"]) {
    const auto then =
        std::find_if(known.totals["touches"].begin(), known.totals["touches"].end(),
                     [&](const json& k) { return k["a"] == touch["a"] && k["b"] == touch["b"]; });
    const std::uint64_t contacts =
        then == known.totals["touches"].end() ? 0 : (*then)["worst"]["contacts"].get<unsigned>();
    if (touch["worst"]["contacts"] <= contacts) continue;
    json entry = touch;
    entry["known"] = contacts;
    EXPECT_NE(std::find(worse.begin(), worse.end(), entry), worse.end()) << entry;
    ++expected;
  }
  EXPECT_GT(expected, 0u);
  EXPECT_EQ(worse.size(), expected);
}

TEST(CheckBaseline, SaysInWordsWhatIsWorse) {
  const LimbsFolder folder;
  run_pelt(folder, 0, {"check", "scene.json", "--frames", "0:1", "--jsonl", "known.jsonl"});
  const Ended run = run_pelt(folder, 1, {"check", "scene.json", "--baseline", "known.jsonl"});
  EXPECT_TRUE(contains(run.out, " new, 0 grown, 0 as known\n"));
  EXPECT_TRUE(contains(run.out, "(new)  frame "));
  EXPECT_TRUE(
      contains(run.out, "note       frames was [0,1,1] in the baseline and is [0,12,1] now"));
}

TEST(CheckBaseline, SaysHowManyMoreThereAreThanItLists) {
  const LimbsFolder folder;
  run_pelt(folder, {"check", "scene.json", "--frames", "0:1", "--jsonl", "known.jsonl"});
  json scene = json::parse(read_text(folder / "scene.json"));
  for (const double x : {-0.2, 0.0, 0.2}) {
    scene["instances"].push_back(scene["instances"][0]);
    scene["instances"].back()["translation"] = {x, 0, 0.05};
  }
  write_text(folder / "scene.json", scene.dump());
  const CheckFile all = check_pairs(folder, 1, {"scene.json", "--baseline", "known.jsonl"});
  const std::size_t worse = all.totals["verdict"]["worse"].size();
  ASSERT_GT(worse, 10u);
  const Ended run = run_pelt(folder, {"check", "scene.json", "--baseline", "known.jsonl"});
  const std::size_t joints = all.totals["touches"].size();  // a limb has one part
  for (const std::size_t listed : {joints, worse})
    EXPECT_TRUE(contains(run.out, "... and " + std::to_string(listed - 10) + " more: --list " +
                                      std::to_string(listed) + "\n"));
}

TEST(CheckBaseline, ReportsWhatIsGone) {
  const LimbsFolder folder;
  run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "known.jsonl"});
  const std::size_t known =
      parse_check_file(read_text(folder / "known.jsonl")).totals["touches"].size();
  const std::string count = std::to_string(known);
  const Ended fewer =
      run_pelt(folder, 0, {"check", "scene.json", "--frames", "0:1", "--baseline", "known.jsonl"});
  EXPECT_TRUE(contains(fewer.out, "gone       " + count + " of " + count + " known touches\n"));
  std::string text = read_text(folder / "scene.json");
  text.replace(text.find("[0.5, 0, 0.03]"), 14, "[9.5, 0, 0.03]");
  write_text(folder / "scene.json", text);
  const CheckFile apart = check_pairs(folder, 0, {"scene.json", "--baseline", "known.jsonl"});
  const json gone = apart.totals["verdict"]["gone"];
  ASSERT_EQ(gone.size(), known);
  EXPECT_EQ(gone[0]["a"]["model"], "one");
  EXPECT_GT(gone[0]["known"], 0);
  const Ended run = run_pelt(folder, {"check", "scene.json", "--baseline", "known.jsonl"});
  EXPECT_TRUE(contains(run.out, count + " known touches: write a new baseline\n"));
}

TEST(CheckFailOn, DecidesTheExitCode) {
  const LimbsFolder folder;
  check_pairs(folder, 0, {"scene.json", "--fail-on", "never"});
  check_pairs(folder, 1, {"scene.json", "--fail-on", "contact"});
  run_pelt(folder, 1, {"check", "scene.json", "--jsonl", "known.jsonl"});
  check_pairs(folder, 1, {"scene.json", "--baseline", "known.jsonl", "--fail-on", "contact"});
  check_pairs(folder, 0, {"scene.json", "--baseline", "known.jsonl", "--fail-on", "new"});
}

TEST(CheckIgnore, LeavesOutWhatItNamesAndNothingElse) {
  const LimbsFolder folder;
  const CheckFile all = check_pairs(folder, 1, {"scene.json"});
  const json touch = all.totals["touches"][0];
  const std::string a = touch["a"]["joint"], b = touch["b"]["joint"];
  const CheckFile file =
      check_pairs(folder, 1, {"scene.json", "--ignore", "one/" + a + "," + "two/" + b});
  EXPECT_EQ(contacts_of(file) + touch["contacts"].get<std::uint64_t>(), contacts_of(all));
  EXPECT_EQ(file.totals["totals"]["ignored"], touch["contacts"]);
  json others = all.totals["touches"];
  others.erase(0);
  EXPECT_EQ(file.totals["touches"], others);
  EXPECT_EQ(file.totals["hash"], hash_of(file));
}

TEST(CheckIgnore, IsInTheSceneFileToo) {
  const LimbsFolder folder;
  std::string text = read_text(folder / "scene.json");
  text.insert(text.rfind('}'), R"(, "ignore": [["joint*", "two/*"]])");
  write_text(folder / "scene.json", text);
  const CheckFile file = check_pairs(folder, 0, {"scene.json"});
  EXPECT_EQ(contacts_of(file), 0u);
  EXPECT_GT(file.totals["totals"]["ignored"], 100u);
  EXPECT_EQ(file.header["options"]["ignore"], json::parse(R"([["joint*", "two/*"]])"));
}

}  // namespace
}  // namespace pelt::test
