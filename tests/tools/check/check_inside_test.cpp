/// `pelt check --inside`: contained bodies, and the depth of bodies that touch.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

/// A large limb and a small one that leaves it: inside in the first frame, outside in the last.
constexpr const char* kLeaving = R"({
  "models": {"one": "one.glb", "two": "two.glb"},
  "frames": {"count": 5, "fps": 1},
  "instances": [
    {"model": "one"},
    {"model": "two", "scale": 0.1, "translation": [0, 0.45, 0], "velocity": [0.05, 0, 0]}
  ]
})";

TEST(CheckInside, ReportsContainedBodiesAndDepths) {
  const LimbsFolder folder;
  write_text(folder / "leaving.json", kLeaving);
  const Ended run = run_pelt(folder, 1, {"check", "leaving.json", "--inside", "--jsonl", "-"});
  EXPECT_TRUE(contains(run.err, "inside     a body is contained in another in frames 0"));
  EXPECT_TRUE(contains(run.err, "deepest    a vertex of two 1 is 0."));
  const CheckFile file = parse_check_file(run.out);
  EXPECT_EQ(file.header["options"]["inside"], true);
  const json& held = file.frames[0]["inside"][0];
  EXPECT_EQ(held["held"], "b");
  EXPECT_EQ(held["a_in_b"], nullptr);
  EXPECT_EQ(file.frames[0]["contacts"], 0);
  int deep = 0;
  for (const json& frame : file.frames) {
    for (const json& pair : frame["inside"]) {
      if (pair["b_in_a"].is_null()) continue;
      ++deep;
      const json& p = pair["b_in_a"]["position"];
      const json& q = pair["b_in_a"]["closest"];
      EXPECT_NEAR(std::hypot(p[0].get<double>() - q[0].get<double>(),
                             p[1].get<double>() - q[1].get<double>(),
                             p[2].get<double>() - q[2].get<double>()),
                  pair["b_in_a"]["depth"].get<double>(), 1e-6);
      EXPECT_GT(frame["contacts"], 0);
    }
  }
  EXPECT_GT(deep, 0);
  EXPECT_EQ(file.frames[4]["inside"], json::array());
}

TEST(CheckInside, SaysThatASingleBodyHasNothingToBeInside) {
  const LimbsFolder folder;
  const Ended run = run_pelt(folder, 0, {"check", "one.glb", "--inside"});
  EXPECT_TRUE(contains(run.out, "inside     not tested: --inside compares different instances"));
}

TEST(CheckInside, HasTheExitCodeOfContactWhereNothingTouches) {
  const LimbsFolder folder;
  write_text(folder / "leaving.json", kLeaving);
  run_pelt(folder, 0, {"check", "leaving.json", "--frames", "0:1"});
  run_pelt(folder, 1, {"check", "leaving.json", "--frames", "0:1", "--inside"});
}

/// The answer for the first frame of kLeaving, in which one limb contains the other.
CheckFile check_held(const TestFolder& folder, Words options, int exit_code) {
  CheckFile file = answer_of(
      folder, exit_code, joined({"check", "leaving.json", "--frames", "0:1", "--inside"}, options));
  EXPECT_EQ(file.totals["verdict"]["failed"], exit_code == 1);
  return file;
}

TEST(CheckInside, IsPartOfTheVerdict) {
  const LimbsFolder folder;
  write_text(folder / "leaving.json", kLeaving);
  const CheckFile file = check_held(folder, {}, 1);
  EXPECT_EQ(file.totals["held"],
            json::parse(R"([{"inner": {"instance": 1, "model": "two", "copy": 0},
                             "outer": {"instance": 0, "model": "one", "copy": 0},
                             "frames": 1, "first_frame": 0}])"));
  check_held(folder, {"--fail-on", "contact"}, 1);
  check_held(folder, {"--fail-on", "never"}, 0);
}

TEST(CheckInside, MayBeInTheBaseline) {
  const LimbsFolder folder;
  write_text(folder / "leaving.json", kLeaving);
  write_text(folder / "known.jsonl",
             run_pelt(folder, {"check", "leaving.json", "--inside", "--jsonl", "-"}).out);
  const CheckFile known = check_held(folder, {"--baseline", "known.jsonl"}, 0);
  EXPECT_EQ(known.totals["verdict"]["newly_held"], json::array());
  check_held(folder, {"--baseline", "known.jsonl", "--fail-on", "contact"}, 1);
  write_text(folder / "free.jsonl", run_pelt(folder, {"check", "leaving.json", "--inside",
                                                      "--frames", "4:5", "--jsonl", "-"})
                                        .out);
  for (const char* fail_on : {"grown", "new"}) {
    const CheckFile file =
        check_held(folder, {"--baseline", "free.jsonl", "--fail-on", fail_on}, 1);
    EXPECT_EQ(file.totals["verdict"]["newly_held"], file.totals["held"]);
  }
  const Ended left = run_pelt(folder, {"check", "leaving.json", "--inside", "--frames", "4:5",
                                       "--baseline", "known.jsonl", "--jsonl", "-"});
  EXPECT_EQ(parse_check_file(left.out).totals["verdict"]["no_longer_held"],
            json::parse(R"([{"inner": {"model": "two", "copy": 0},
                             "outer": {"model": "one", "copy": 0}}])"));
  EXPECT_TRUE(contains(left.err, " known touches, and 1 known contained bod"));
}

TEST(CheckInside, IsIgnoredWhereBothBodiesAreNamedWhole) {
  const LimbsFolder folder;
  write_text(folder / "leaving.json", kLeaving);
  const CheckFile file = check_held(folder, {"--ignore", "one/*,two/*"}, 0);
  EXPECT_EQ(file.totals["held"], json::array());
  EXPECT_EQ(file.frames[0]["inside"], json::array());
  check_held(folder, {"--ignore", "two/limb,one/limb"}, 0);
  check_held(folder, {"--ignore", "one/*,one/*"}, 1);
  check_held(folder, {"--ignore", "one/*,two/joint 0"}, 1);
}

TEST(CheckInside, SaysWhereNothingIsClosed) {
  const StripFolder folder;
  const Ended run = run_pelt(folder, {"check", "strip.glb", "strip.glb", "--inside", "--at",
                                      "0,0,0", "--at", "9,0,0", "--frames", "0:1"});
  EXPECT_TRUE(contains(run.out, "no surface is closed"));
}

}  // namespace
}  // namespace pelt::test
