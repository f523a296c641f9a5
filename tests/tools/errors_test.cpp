/// Bad input and arguments: exit code 2, nothing on standard output, and one line on standard error
/// with the cause and the remedy.

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

struct Refusal {
  Words arguments;
  Words words;  ///< in the message
};

class Refused : public ::testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithAMessage) {
  const LimbsFolder folder;
  write_strip(folder, "strip.glb");
  write_text(folder / "broken.glb", "no glTF");
  write_text(folder / "cut.glb", read_text(folder / "strip.glb").substr(0, 500));
  write_text(folder / "broken.json", "{");
  write_text(folder / "no_model.json", R"({"models": {"a": "none.glb"}, "instances": []})");
  const Ended run = run_pelt(folder, 2, GetParam().arguments);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_EQ(run.err.rfind("pelt: error: ", 0), 0u) << run.err;
  for (const std::string& word : GetParam().words) {
    EXPECT_TRUE(contains(run.err, word));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, Refused,
    ::testing::Values(
        Refusal{{"check", "none.json"}, {"none.json", "no such file"}},
        Refusal{{"check", "none.glb"}, {"none.glb", "no such file"}},
        Refusal{{"check", "none.glb", "--exclude", "fan"}, {"none.glb", "--exclude none.glb"}},
        Refusal{{"check", "strip.glb", "--exclude", "fan", "paper"},
                {"error: paper: there is no such file", "each --exclude has one name",
                 "give --exclude paper"}},
        Refusal{{"check", "broken.glb"}, {"broken.glb: ", "export"}},
        Refusal{{"info", "cut.glb"}, {"cut.glb: ", "truncated", "copy or export"}},
        Refusal{{"bench", "strip.glb", "--clip", "bnd"},
                {"--clip", "\"bnd\"", "did you mean \"bend\"?"}},
        Refusal{{"bench", "scene.json", "--clip", "bend"}, {"--clip", "edit the scene file"}},
        Refusal{{"check", "broken.json"}, {"broken.json: the JSON text"}},
        Refusal{{"check", "no_model.json"},
                {"no_model.json: models.a: none.glb", "relative to its folder"}},
        Refusal{{"check", "."}, {".: "}},
        Refusal{{"check", "scene.json", "--jsonl", "no/folder/a"},
                {"no/folder/a: cannot be written"}},
        Refusal{{"check", "scene.json", "--baseline", "none.jsonl"},
                {"--baseline: none.jsonl", "written by pelt check --jsonl"}},
        Refusal{
            {"check", "scene.json", "--baseline", "scene.json"},
            {"--baseline: scene.json: is not a complete answer", "written by pelt check --jsonl"}},
        Refusal{{"info", "none.glb"}, {"none.glb"}},
        Refusal{{"pose", "scene.json", "--frame", "0", "-o", "no/folder/a"}, {"no/folder/a"}},
        Refusal{{"demo", "-o", "scene.json/x"}, {"scene.json/x", "-o"}},
        Refusal{{"bench", "none.json"}, {"none.json"}},
        Refusal{{"bench", "scene.json", "--json", "no/folder/a"},
                {"no/folder/a: cannot be written"}}));

INSTANTIATE_TEST_SUITE_P(
    Placing, Refused,
    ::testing::Values(
        Refusal{{"check", "scene.json", "strip.glb"}, {"scene.json", "a single scene file"}},
        Refusal{{"check", "scene.json", "--clip", "walk"}, {"--clip", "edit scene.json"}},
        Refusal{{"check", "strip.glb", "--clip", "a", "--clip", "b"},
                {"--clip", "2 times for 1 model"}},
        Refusal{{"check", "strip.glb", "--at", "0,0,0", "--at", "0,0,0"}, {"--at", "2 times"}},
        Refusal{{"check", "strip.glb", "--clip", "bnd"},
                {"--clip", "\"bnd\"", "did you mean \"bend\"?"}},
        Refusal{{"check", "strip.glb", "--at", "1,2"}, {"--at", "\"1,2\"", "x,y,z"}},
        Refusal{{"check", "strip.glb", "--at", "1,2,inf"}, {"--at", "x,y,z"}},
        Refusal{{"check", "strip.glb", "--scale", "0"}, {"--scale: \"0\" is not allowed", "1e-6"}},
        Refusal{{"check", "strip.glb", "--scale", "-1"}, {"--scale"}},
        Refusal{{"check", "strip.glb", "--scale", "nan"}, {"--scale"}},
        Refusal{{"check", "strip.glb", "--turn", "left"},
                {"--turn: \"left\" is not a number: give a number"}},
        Refusal{{"check", "strip.glb", "--turn", "1e300"}, {"--turn: \"1e+300\" is not allowed"}},
        Refusal{{"check", "strip.glb", "--start", "-1e300"},
                {"--start: \"-1e+300\" is not allowed"}},
        Refusal{{"check", "strip.glb", "--fps", "fast"}, {"--fps: \"fast\" is not a number"}},
        Refusal{{"check", "strip.glb", "--fps", "0"}, {"--fps", "1e-6"}}));

INSTANTIATE_TEST_SUITE_P(
    Options, Refused,
    ::testing::Values(
        Refusal{{"check"}, {"INPUT", "see pelt check --help"}},
        Refusal{{}, {"no verb is given", "\"check\"", "see pelt --help"}},
        Refusal{{"chek", "scene.json"}, {"\"chek\" is not a verb", "\"check\"", "--help"}},
        Refusal{{"check", "scene.json", "--fast"},
                {"there is no option \"--fast\": see pelt check --help"}},
        Refusal{{"check", "--htlm=report.html"},
                {"there is no option \"--htlm\", did you mean \"--html\"?: see pelt check --help"}},
        Refusal{{"info", "strip.glb", "scene.json"},
                {"\"scene.json\" is an unexpected argument: see pelt info --help"}},
        Refusal{{"check", "scene.json", "--frames", "9:4"}, {"--frames", "9:4"}},
        Refusal{{"check", "scene.json", "--frames", "0:13"},
                {"--frames", "0:13", "has frames 0:12"}},
        Refusal{{"check", "strip.glb", "--frames", "0:1000001"}, {"--frames", "0:1000001"}},
        Refusal{{"check", "scene.json", "--method", "papr"},
                {"--method", "did you mean \"paper\"?"}},
        Refusal{{"check", "scene.json", "--method", "magic"}, {"--method", "\"eager\""}},
        Refusal{{"check", "scene.json", "--method", "rigid"}, {"--method", "\"rigid\"", "paper"}},
        Refusal{{"check", "scene.json", "--simd", "mmx"}, {"--simd", "\"mmx\"", "scalar"}},
        Refusal{{"check", "scene.json", "--samples", "-1"}, {"--samples"}},
        Refusal{{"check", "scene.json", "--by", "joint"}, {"--by", "instance or part"}},
        Refusal{{"check", "scene.json", "--max-contacts", "0"},
                {"--max-contacts: \"0\" is not allowed", "whole number from 1 to 4294967295"}},
        Refusal{{"check", "scene.json", "--max-contacts", "-3"},
                {"--max-contacts: \"-3\" is not allowed", "whole number from 1 to 4294967295"}},
        Refusal{{"check", "scene.json", "--max-contacts", "4294967296"},
                {"--max-contacts: \"4294967296\" is not allowed"}},
        Refusal{{"check", "scene.json", "--list", "0"},
                {"--list: \"0\" is not allowed", "whole number from 1"}},
        Refusal{{"check", "scene.json", "--glb", "a.glb", "--glb-frame", "-1"},
                {"--glb-frame: \"-1\" is not allowed", "whole number from 0"}},
        Refusal{{"check", "scene.json", "--clearance", "wide"},
                {"--clearance: \"wide\" is not a number"}},
        Refusal{{"check", "scene.json", "--first", "--max-contacts", "3"}, {"--first"}},
        Refusal{{"check", "scene.json", "--glb-frame", "3"}, {"--glb-frame", "--glb FILE"}},
        Refusal{{"check", "scene.json", "--frames", "0:9:4", "--glb", "a.glb", "--glb-frame", "3"},
                {"--glb-frame", "3 is not a checked frame"}},
        Refusal{{"pose", "scene.json", "-o", "a.glb"}, {"--frame"}},
        Refusal{{"pose", "scene.json", "--frame", "3"}, {"--output"}},
        Refusal{{"pose", "scene.json", "--frame", "12", "-o", "a.glb"},
                {"--frame: 12 is beyond the last frame", "12 frames"}},
        Refusal{{"bench", "scene.json", "--methods", "paper,quick"}, {"--methods", "\"quick\""}},
        Refusal{{"bench", "scene.json", "--queries", "al"}, {"--queries", "\"all\""}},
        Refusal{{"bench", "scene.json", "--simd", "sse9"}, {"--simd", "\"sse9\"", "scalar"}},
        Refusal{{"bench", "scene.json", "--repeat", "0"}, {"--repeat", "from 1"}},
        Refusal{{"bench", "scene.json", "--threads", "0"}, {"--threads", "\"0\"", "1 to 256"}},
        Refusal{{"bench", "scene.json", "--threads", "1,two"}, {"--threads", "\"two\""}},
        Refusal{{"bench", "scene.json", "--threads", "257"}, {"--threads", "\"257\""}},
        Refusal{{"bench", "scene.json", "--threads", "2", "--methods", "paper"},
                {"--threads", "add on_demand to --methods"}},
        Refusal{{"bench", "scene.json", "--frames", "0:13"}, {"--frames", "has frames 0:12"}}));

INSTANTIATE_TEST_SUITE_P(
    Queries, Refused,
    ::testing::Values(
        Refusal{{"bounds", "none.glb"}, {"none.glb", "no such file"}},
        Refusal{{"bounds", "scene.json", "--by", "bone"}, {"--by", "instance, part or joint"}},
        Refusal{{"bounds", "scene.json", "--frames", "12:13"}, {"--frames", "has frames 0:12"}},
        Refusal{{"bounds", "scene.json", "--jsonl", "no/folder/a"},
                {"no/folder/a: cannot be written"}},
        Refusal{{"bounds", "scene.json", "--simd", "mmx"}, {"--simd", "\"mmx\""}},
        Refusal{{"distance", "scene.json", "--within", "-1"}, {"--within", "0 to 1e12"}},
        Refusal{{"distance", "scene.json", "--within", "nan"}, {"--within", "0 to 1e12"}},
        Refusal{{"distance", "scene.json", "--list", "3", "--from", "0,0,0"}, {"--list", "--from"}},
        Refusal{{"distance", "scene.json", "--by", "joint"}, {"--by", "instance or part"}},
        Refusal{{"distance", "scene.json", "--frames", "0:13"}, {"--frames", "has frames 0:12"}},
        Refusal{{"check", "scene.json", "--clearance", "-0.5"}, {"--clearance", "0 to 1e12"}},
        Refusal{{"check", "scene.json", "--clearance", "nan"}, {"--clearance", "0 to 1e12"}},
        Refusal{{"check", "scene.json", "--clearance", "1", "--method", "eager"},
                {"--clearance", "leave out --method"}},
        Refusal{{"check", "scene.json", "--clearance", "1", "--contacts"},
                {"--clearance", "--contacts", "one of the two"}},
        Refusal{{"ray", "scene.json", "--from", "0,0,0"}, {"--to", "see pelt ray --help"}},
        Refusal{{"ray", "scene.json", "--from", "0,0", "--to", "1,0,0"},
                {"--from: \"0,0\" is not a position", "x,y,z"}},
        Refusal{{"ray", "scene.json", "--from", "0,0,0", "--to", "1,two,0"}, {"--to", "1,two,0"}},
        Refusal{{"ray", "scene.json", "--from", "nan,0,0", "--to", "1,0,0"}, {"--from", "nan,0,0"}},
        Refusal{{"ray", "scene.json", "--from", "0,0,0", "--to", "inf,0,0"}, {"--to", "inf,0,0"}},
        Refusal{{"ray", "scene.json", "--from", "1,2,3", "--to", "1,2,3"},
                {"--to: \"1,2,3\" is the same point as --from", "another point"}},
        Refusal{{"ray", "scene.json", "--from", "1,2,3", "--from", "1,2,4", "--to", "0,2,3"},
                {"--to", "1 time and --from 2 times", "both options for each ray"}},
        Refusal{{"ray", "scene.json", "--from", "0,0,0", "--to", "1,0,0", "--facing", "up"},
                {"--facing", "both, front or back"}},
        Refusal{{"ray", "scene.json", "--from", "0,0,0", "--to", "1,0,0", "--frames", "3:99"},
                {"--frames", "has frames 0:12"}}));

}  // namespace
}  // namespace pelt::test
