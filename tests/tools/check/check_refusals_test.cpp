/// Invalid ignored names and baselines, which `pelt check` refuses before it writes anything.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

struct RefusedCheck {
  Words options;
  Words words;  ///< in the message
  std::string scene = "scene.json";
};

class CheckRefuses : public ::testing::TestWithParam<RefusedCheck> {};

/// Each call also names a --jsonl file, which must stay unchanged.
TEST_P(CheckRefuses, WithAMessageAndWritesNothing) {
  const LimbsFolder folder;
  write_text(folder / "answer.jsonl", "an earlier answer\n");
  run_pelt(folder, {"check", "scene.json", "--jsonl", "known.jsonl"});
  std::string text = read_text(folder / "scene.json");
  text.insert(text.rfind('}'), R"(, "ignore": [["limb", "wing"]])");
  write_text(folder / "rotten.json", text);
  const Ended run =
      run_pelt(folder, 2,
               joined({"check", GetParam().scene, "--jsonl", "answer.jsonl"}, GetParam().options));
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  for (const std::string& word : GetParam().words) EXPECT_TRUE(contains(run.err, word));
  EXPECT_EQ(read_text(folder / "answer.jsonl"), "an earlier answer\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "answer.jsonl.partial"));
}

INSTANTIATE_TEST_SUITE_P(
    Ignore, CheckRefuses,
    ::testing::Values(
        RefusedCheck{{"--ignore", "limb,wing"},
                     {"error: --ignore: no part and no joint is named \"wing\"", "\"limb\""}},
        RefusedCheck{{"--ignore", "onee/limb,two/*"}, {"\"onee/limb\", did you mean \"one/limb\""}},
        RefusedCheck{{"--ignore", "limb"}, {"--ignore: \"limb\" is no", "--ignore cape,spine"}},
        RefusedCheck{{"--ignore", ",limb"}, {"--ignore: \",limb\" is no"}},
        RefusedCheck{{"--ignore", "limb,"}, {"--ignore: \"limb,\" is no"}},
        RefusedCheck{{"--ignore", "limb,limb", "--first"},
                     {"--first: cannot be combined with ignored pairs"}},
        RefusedCheck{{"--ignore", "limb,limb", "--max-contacts", "3"},
                     {"--max-contacts: cannot be combined with ignored pairs"}},
        RefusedCheck{{},
                     {"error: rotten.json: ignore: no part and no joint is named \"wing\""},
                     "rotten.json"}));

INSTANTIATE_TEST_SUITE_P(Outputs, CheckRefuses,
                         ::testing::Values(RefusedCheck{{"--glb", "no/folder/a.glb"},
                                                        {"no/folder/a.glb: cannot be written"}}));

INSTANTIATE_TEST_SUITE_P(
    Baseline, CheckRefuses,
    ::testing::Values(
        RefusedCheck{{"--baseline", "known.jsonl", "--first"},
                     {"--baseline: requires all contacts", "leave out --first"}},
        RefusedCheck{{"--baseline", "known.jsonl", "--max-contacts", "9"},
                     {"requires all contacts"}},
        RefusedCheck{{"--baseline", "answer.jsonl"}, {"--jsonl: answer.jsonl is the baseline"}},
        RefusedCheck{{"--baseline", "./answer.jsonl"}, {"--jsonl: answer.jsonl is the baseline"}},
        RefusedCheck{{"--baseline", "known.jsonl", "--glb", "known.jsonl"},
                     {"--glb: known.jsonl is the baseline"}},
        RefusedCheck{{"--baseline", "known.jsonl", "--by", "part"},
                     {"was written --by instance, but this check is --by part"}},
        RefusedCheck{{"--baseline", "known.jsonl", "--clearance", "0.1"},
                     {"without --clearance, but this check is --clearance 0.1"}},
        RefusedCheck{{"--baseline", "known.jsonl", "--inside"}, {"was written without --inside"}},
        RefusedCheck{{"--fail-on", "worse"},
                     {"--fail-on", "contact, between, grown, new, unknown or never"}},
        RefusedCheck{{"--fail-on", "new"}, {"--fail-on: new requires", "--baseline FILE"}},
        RefusedCheck{{"--fail-on", "grown"}, {"--fail-on: grown requires", "--baseline FILE"}}));

TEST(CheckIgnore, MayNameInASceneWhatIsLeftOut) {
  const StripFolder folder;
  write_text(folder / "scene.json", R"({
    "models": {"strip": "strip.glb"},
    "instances": [{"model": "strip"}, {"model": "strip", "translation": [0.25, 0, 0.1]}],
    "ignore": [["fan", "paper"]]})");
  EXPECT_LT(run_pelt(folder, {"check", "scene.json"}).exit_code, 2);
  for (const Words& options : {std::vector<std::string>{"--exclude", "fan"}, {"--no-unskinned"}}) {
    Words arguments = {"check", "scene.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended run = run_pelt(folder, arguments);
    EXPECT_LT(run.exit_code, 2) << run.err;
    arguments.insert(arguments.end(), {"--ignore", "fan,paper"});
    run_pelt(folder, 2, arguments);
  }
}

}  // namespace
}  // namespace pelt::test
