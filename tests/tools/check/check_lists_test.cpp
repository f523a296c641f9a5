/// The lists of `pelt check`, their length and their order.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

Ended check_limbs_with(const TestFolder& folder, const Words& words) {
  return run_pelt(folder, joined({"check", "scene.json"}, words));
}

/// Writes known.jsonl, an answer for the limbs in which one touch is missing, one touch is
/// unchanged, and all others have fewer contacts. The missing touch has the fewest contacts.
void write_worse_baseline(const TestFolder& folder) {
  ASSERT_EQ(check_limbs_with(folder, {"--jsonl", "now.jsonl"}).exit_code, 1);
  Words lines = lines_of(read_text(folder / "now.jsonl"));
  json last = json::parse(lines.back());
  json& touches = last["touches"];
  ASSERT_GT(touches.size(), 3u);
  const auto fewer = [](const json& a, const json& b) {
    return a["worst"]["contacts"] < b["worst"]["contacts"];
  };
  touches.erase(std::min_element(touches.begin(), touches.end(), fewer));
  for (std::size_t i = 1; i < touches.size(); ++i) {
    json& contacts = touches[i]["worst"]["contacts"];
    contacts = contacts.get<int>() / 2 + 1;
  }
  lines.back() = last.dump();
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  write_text(folder / "known.jsonl", text);
}

TEST(CheckLists, GiveWhatIsNewFirst) {
  const LimbsFolder folder;
  write_worse_baseline(folder);
  const Ended run = check_limbs_with(
      folder, {"--baseline", "known.jsonl", "--fail-on", "new", "--jsonl", "answer.jsonl"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const json worse =
      parse_check_file(read_text(folder / "answer.jsonl")).totals["verdict"]["worse"];
  ASSERT_GT(worse.size(), 1u);
  EXPECT_EQ(worse[0]["known"], 0);
  EXPECT_LT(worse[0]["worst"]["contacts"], worse[1]["worst"]["contacts"]);
  for (std::size_t i = 1; i < worse.size(); ++i) {
    EXPECT_GT(worse[i]["known"], 0);
    if (i > 1) {
      EXPECT_LE(worse[i]["worst"]["contacts"], worse[i - 1]["worst"]["contacts"]);
    }
  }
  const std::size_t fresh = run.out.find("(new)"), grown = run.out.find("(was ");
  const std::size_t touching = run.out.find("joints that touch");
  ASSERT_NE(grown, std::string::npos) << run.out;
  ASSERT_NE(touching, std::string::npos) << run.out;
  EXPECT_LT(fresh, grown) << run.out;
  EXPECT_LT(grown, touching) << run.out;
}

std::size_t count_of(const std::string& words, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = words.find(text); at != words.npos; at = words.find(text, at + 1)) ++count;
  return count;
}

TEST(CheckLists, AreAsLongAsTheOptionSays) {
  const LimbsFolder folder;
  const auto rows = [&](const Words& options) {
    const std::string words = check_limbs_with(folder, options).out;
    return std::pair(count_of(words, ", worst frame "), words);
  };
  const auto [all, words_of_all] = rows({});
  ASSERT_GT(all, 3u);
  EXPECT_FALSE(contains(words_of_all, "more: --list"));
  const auto [two, words_of_two] = rows({"--list", "2"});
  EXPECT_EQ(two, 2u) << words_of_two;
  const std::string as_long = std::to_string(all);
  EXPECT_TRUE(
      contains(words_of_two, "... and " + std::to_string(all - 2) + " more: --list " + as_long));
  EXPECT_EQ(rows({"--list", as_long}).first, all);
}

TEST(CheckLists, DoNotCallGoneWhatIsLeftOut) {
  const StripFolder folder;
  const auto compare = [&](const Words& options) {
    const Ended run = run_pelt(
        folder, joined({"check", "strip.glb", "strip.glb", "--at", "0,0,0", "--at", "0.25,0,0.1",
                        "--baseline", "known.jsonl", "--jsonl", "answer.jsonl"},
                       options));
    EXPECT_LT(run.exit_code, 2) << run.err;
    return std::pair(run.out, parse_check_file(read_text(folder / "answer.jsonl")).totals);
  };
  run_pelt(folder, 1,
           {"check", "strip.glb", "strip.glb", "--at", "0,0,0", "--at", "0.25,0,0.1", "--jsonl",
            "known.jsonl"});
  const json all = compare({}).second["verdict"];
  EXPECT_EQ(all["gone"], json::array());
  EXPECT_EQ(all["left_out"], json::array());
  for (const Words& options : {Words{"--exclude", "fan"}, Words{"--no-unskinned"}}) {
    const auto [words, totals] = compare(options);
    const json& verdict = totals["verdict"];
    EXPECT_EQ(verdict["gone"], json::array()) << verdict["gone"];
    ASSERT_FALSE(verdict["left_out"].empty());
    for (const json& touch : verdict["left_out"])
      EXPECT_TRUE(touch["a"]["part"] == "fan" || touch["b"]["part"] == "fan") << touch;
    EXPECT_TRUE(contains(words, "left out"));
    EXPECT_FALSE(contains(words, "gone"));
  }
}

TEST(CheckLists, CallGoneWhatTheFileHasNoLonger) {
  const StripFolder folder;
  const Words first = {"check", "strip.glb", "--by", "part", "--jsonl", "known.jsonl"};
  run_pelt(folder, 1, first);
  GltfBuilder strip = strip_with_fan();
  for (json& node : strip.document["nodes"]) {
    if (node["name"] == "fan") node["name"] = "sail";
  }
  write_bytes(folder / "strip.glb", strip.glb());
  const Ended run = run_pelt(
      folder, {"check", "strip.glb", "--by", "part", "--baseline", "known.jsonl", "--jsonl", "-"});
  const json verdict = parse_check_file(run.out).totals["verdict"];
  EXPECT_FALSE(verdict["gone"].empty());
  EXPECT_EQ(verdict["left_out"], json::array());
}

}  // namespace
}  // namespace pelt::test
