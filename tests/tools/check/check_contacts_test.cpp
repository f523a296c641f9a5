/// `pelt check --contacts`: the added geometry is consistent with the contacts and with itself.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

CheckFile described(const TestFolder& folder, const Words& words) {
  return check_pairs(folder, 1, joined(words, {"--contacts"}));
}

std::vector<json> pairs_of(const CheckFile& file) {
  std::vector<json> pairs;
  for (const json& frame : file.frames)
    for (const json& pair : frame["pairs"]) pairs.push_back(pair);
  return pairs;
}

TEST(CheckContacts, HasATraceForEachContact) {
  const LimbsFolder folder;
  const CheckFile file = described(folder, {"scene.json"});
  EXPECT_EQ(file.header["options"]["contacts"], true);
  const std::vector<json> pairs = pairs_of(file);
  ASSERT_GE(pairs.size(), 2u);
  for (const json& pair : pairs) {
    ASSERT_EQ(pair["traces"].size(), pair["contacts"]);
    for (std::size_t t = 0; t < pair["traces"].size(); ++t) {
      const json& trace = pair["traces"][t];
      EXPECT_EQ(trace["triangles"], pair["triangles"][t]);
      EXPECT_EQ(trace["joints"].size(), 2u);
      EXPECT_EQ(trace["joints"][0].get<std::string>().rfind("joint ", 0), 0u);
    }
  }
}

TEST(CheckContacts, ChainsSegmentsToCurves) {
  const LimbsFolder folder;
  std::size_t closed = 0;
  for (const json& pair : pairs_of(described(folder, {"scene.json"}))) {
    std::size_t segments = 0, steps = 0;
    for (const json& trace : pair["traces"]) segments += trace["kind"] == "segment";
    for (const json& curve : pair["curves"]) {
      const json &traces = curve["traces"], &points = curve["points"];
      steps += traces.size();
      ASSERT_EQ(points.size(), traces.size() + 1);
      for (std::size_t i = 0; i < traces.size(); ++i) {
        const json& trace = pair["traces"][traces[i].get<std::size_t>()];
        const bool forward = trace["from"] == points[i] && trace["to"] == points[i + 1];
        const bool backward = trace["to"] == points[i] && trace["from"] == points[i + 1];
        EXPECT_TRUE(forward || backward);
      }
      if (!curve["closed"]) continue;
      ++closed;
      EXPECT_EQ(points.front(), points.back());
    }
    EXPECT_EQ(steps, segments);
  }
  EXPECT_GT(closed, 0u);  // both limbs are closed surfaces
}

TEST(CheckContacts, GathersAllContactsToPatches) {
  const LimbsFolder folder;
  std::size_t patches = 0;
  for (const json& pair : pairs_of(described(folder, {"scene.json"}))) {
    std::vector<std::size_t> members;
    for (const json& patch : pair["patches"]) {
      ++patches;
      double deepest = 0;
      for (const std::size_t t : patch["traces"]) {
        members.push_back(t);
        deepest = std::max(deepest, pair["traces"][t]["depth"].get<double>());
      }
      EXPECT_EQ(patch["depth"], deepest);
      EXPECT_GT(patch["length"], 0);
      EXPECT_EQ(patch["parts"], json::array({"limb", "limb"}));
      EXPECT_EQ(patch["joints"].size(), 2u);
    }
    std::sort(members.begin(), members.end());
    ASSERT_EQ(members.size(), pair["contacts"]);
    for (std::size_t i = 0; i < members.size(); ++i) EXPECT_EQ(members[i], i);
  }
  EXPECT_GT(patches, 0u);
}

TEST(CheckContacts, DoesNotDependOnTheMethod) {
  const LimbsFolder folder;
  const auto crowd = pairs_of(described(folder, {"scene.json"}));
  EXPECT_EQ(pairs_of(described(folder, {"scene.json", "--method", "eager"})), crowd);
}

TEST(CheckContacts, PartsKeepTheNumbersOfTheModel) {
  const StripFolder folder;
  const std::vector<json> pairs = pairs_of(described(folder, {"strip.glb", "--by", "part"}));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0]["traces"][0]["triangles"], pairs[0]["triangles"][0]);
  EXPECT_EQ(pairs[0]["patches"][0]["parts"], json::array({"paper", "fan"}));
}

TEST(CheckContacts, AreWrittenOnlyOnRequest) {
  const LimbsFolder folder;
  const Ended run = run_pelt(folder, {"check", "scene.json", "--jsonl", "-"});
  const std::vector<json> pairs = pairs_of(parse_check_file(run.out));
  ASSERT_GE(pairs.size(), 1u);
  for (const char* key : {"traces", "curves", "patches"}) EXPECT_FALSE(pairs[0].contains(key));
  EXPECT_FALSE(contains(run.err, "longest patches"));
}

/// The lengths of the rows of a list.
std::vector<double> numbers_of_list(const std::string& words, const std::string& title) {
  std::vector<double> numbers;
  std::istringstream lines(words.substr(words.find('\n', words.find(title)) + 1));
  for (std::string line; std::getline(lines, line) && !line.empty() && line[0] == ' ';) {
    if (line.find("... and") == line.npos) numbers.push_back(std::stod(line));
  }
  return numbers;
}

TEST(CheckContacts, SummaryNamesTheJointsOfTheLongestPatches) {
  const LimbsFolder folder;
  const Ended run =
      run_pelt(folder, {"check", "scene.json", "--contacts", "--jsonl", "answer.jsonl"});
  for (const char* words : {"patches    ", "longest patches", "one 0 joint ", "two 1 joint "})
    EXPECT_TRUE(contains(run.out, words));
  double longest = 0;
  for (const json& pair : pairs_of(parse_check_file(read_text(folder / "answer.jsonl"))))
    for (const json& patch : pair["patches"])
      longest = std::max(longest, patch["length"].get<double>());
  const std::vector<double> listed = numbers_of_list(run.out, "longest patches");
  ASSERT_FALSE(listed.empty()) << run.out;
  EXPECT_NEAR(listed[0], longest, 1e-6);
  EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end(), std::greater<>())) << run.out;
}

}  // namespace
}  // namespace pelt::test
