/// `pelt check` for a build server: ignored pairs, baselines, failures.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <algorithm>

namespace pelt::test {
namespace {

/// The answer for the limbs' scene, with the triangles.
CheckFile check_limbs(const TestFolder& folder, std::vector<std::string> options, int exit_code) {
  std::vector<std::string> arguments = {"check", "scene.json", "--jsonl", "-", "--pairs"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Ended run = run_pelt(folder, arguments);
  EXPECT_EQ(run.exit_code, exit_code) << run.err;
  return parse_check_file(run.out);
}

std::uint64_t contacts_of(const CheckFile& file) { return file.totals["totals"]["contacts"]; }

/// Moves one limb of the scene closer: places that touched then have more contacts.
void move_limb(const TestFolder& folder) {
  std::string text = read_text(folder / "scene.json");
  const std::string place = "[0.5, 0, 0.03]";
  ASSERT_NE(text.find(place), std::string::npos);
  write_text(folder / "scene.json", text.replace(text.find(place), place.size(), "[0.5, 0, 0.0]"));
}

TEST(CheckTouches, AddUpToAllContacts) {
  const TestFolder folder;
  write_limbs(folder);
  const CheckFile file = check_limbs(folder, {}, 1);
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
  const TestFolder folder;
  write_limbs(folder);
  ASSERT_EQ(run_pelt(folder, {"check", "scene.json", "--jsonl", "known.jsonl"}).exit_code, 1);
  const CheckFile file = check_limbs(folder, {"--baseline", "known.jsonl"}, 0);
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
  const TestFolder folder;
  write_limbs(folder);
  ASSERT_EQ(run_pelt(folder, {"check", "scene.json", "--jsonl", "known.jsonl"}).exit_code, 1);
  move_limb(folder);
  const CheckFile file = check_limbs(folder, {"--baseline", "known.jsonl"}, 1);
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
  const TestFolder folder;
  write_limbs(folder);
  ASSERT_EQ(run_pelt(folder, {"check", "scene.json", "--frames", "0:1", "--jsonl", "known.jsonl"})
                .exit_code,
            0);
  const Ended run = run_pelt(folder, {"check", "scene.json", "--baseline", "known.jsonl"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find(" new, 0 grown, 0 as known\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("(new)  frame "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("note       frames was [0,1,1] in the baseline and is [0,12,1] now"),
            std::string::npos)
      << run.out;
}

TEST(CheckBaseline, SaysHowManyMoreThereAreThanItLists) {
  const TestFolder folder;
  write_limbs(folder);
  run_pelt(folder, {"check", "scene.json", "--frames", "0:1", "--jsonl", "known.jsonl"});
  json scene = json::parse(read_text(folder / "scene.json"));
  for (const double x : {-0.2, 0.0, 0.2}) {
    scene["instances"].push_back(scene["instances"][0]);
    scene["instances"].back()["translation"] = {x, 0, 0.05};
  }
  write_text(folder / "scene.json", scene.dump());
  const CheckFile all = check_limbs(folder, {"--baseline", "known.jsonl"}, 1);
  const std::size_t worse = all.totals["verdict"]["worse"].size();
  ASSERT_GT(worse, 10u);
  const Ended run = run_pelt(folder, {"check", "scene.json", "--baseline", "known.jsonl"});
  const std::size_t joints = all.totals["touches"].size();  // a limb has one part
  for (const std::size_t listed : {joints, worse})
    EXPECT_NE(run.out.find("... and " + std::to_string(listed - 10) + " more: --list " +
                           std::to_string(listed) + "\n"),
              std::string::npos)
        << run.out;
}

TEST(CheckBaseline, ReportsWhatIsGone) {
  const TestFolder folder;
  write_limbs(folder);
  ASSERT_EQ(run_pelt(folder, {"check", "scene.json", "--jsonl", "known.jsonl"}).exit_code, 1);
  const std::size_t known =
      parse_check_file(read_text(folder / "known.jsonl")).totals["touches"].size();
  const std::string count = std::to_string(known);
  const Ended fewer =
      run_pelt(folder, {"check", "scene.json", "--frames", "0:1", "--baseline", "known.jsonl"});
  EXPECT_EQ(fewer.exit_code, 0);
  EXPECT_NE(fewer.out.find("gone       " + count + " of " + count + " known touches\n"),
            std::string::npos)
      << fewer.out;
  std::string text = read_text(folder / "scene.json");
  text.replace(text.find("[0.5, 0, 0.03]"), 14, "[9.5, 0, 0.03]");
  write_text(folder / "scene.json", text);
  const CheckFile apart = check_limbs(folder, {"--baseline", "known.jsonl"}, 0);
  const json gone = apart.totals["verdict"]["gone"];
  ASSERT_EQ(gone.size(), known);
  EXPECT_EQ(gone[0]["a"]["model"], "one");
  EXPECT_GT(gone[0]["known"], 0);
  const Ended run = run_pelt(folder, {"check", "scene.json", "--baseline", "known.jsonl"});
  EXPECT_NE(run.out.find(count + " known touches: write a new baseline\n"), std::string::npos)
      << run.out;
}

TEST(CheckFailOn, DecidesTheExitCode) {
  const TestFolder folder;
  write_limbs(folder);
  check_limbs(folder, {"--fail-on", "never"}, 0);
  check_limbs(folder, {"--fail-on", "contact"}, 1);
  ASSERT_EQ(run_pelt(folder, {"check", "scene.json", "--jsonl", "known.jsonl"}).exit_code, 1);
  check_limbs(folder, {"--baseline", "known.jsonl", "--fail-on", "contact"}, 1);
  check_limbs(folder, {"--baseline", "known.jsonl", "--fail-on", "new"}, 0);
}

TEST(CheckIgnore, LeavesOutWhatItNamesAndNothingElse) {
  const TestFolder folder;
  write_limbs(folder);
  const CheckFile all = check_limbs(folder, {}, 1);
  const json touch = all.totals["touches"][0];
  const std::string a = touch["a"]["joint"], b = touch["b"]["joint"];
  const CheckFile file = check_limbs(folder, {"--ignore", "one/" + a + "," + "two/" + b}, 1);
  EXPECT_EQ(contacts_of(file) + touch["contacts"].get<std::uint64_t>(), contacts_of(all));
  EXPECT_EQ(file.totals["totals"]["ignored"], touch["contacts"]);
  json others = all.totals["touches"];
  others.erase(0);
  EXPECT_EQ(file.totals["touches"], others);
  EXPECT_EQ(file.totals["hash"], hash_of(file));
}

TEST(CheckIgnore, IsInTheSceneFileToo) {
  const TestFolder folder;
  write_limbs(folder);
  std::string text = read_text(folder / "scene.json");
  text.insert(text.rfind('}'), R"(, "ignore": [["joint*", "two/*"]])");
  write_text(folder / "scene.json", text);
  const CheckFile file = check_limbs(folder, {}, 0);
  EXPECT_EQ(contacts_of(file), 0u);
  EXPECT_GT(file.totals["totals"]["ignored"], 100u);
  EXPECT_EQ(file.header["options"]["ignore"], json::parse(R"([["joint*", "two/*"]])"));
}

}  // namespace
}  // namespace pelt::test
