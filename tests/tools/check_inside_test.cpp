/// `pelt check --inside`: bodies held whole, and how deep those are that touch.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

/// A large limb and a small one that leaves it: inside in the first frame, beside it in the last.
constexpr const char* kLeaving = R"({
  "models": {"one": "one.glb", "two": "two.glb"},
  "frames": {"count": 5, "fps": 1},
  "instances": [
    {"model": "one"},
    {"model": "two", "scale": 0.1, "translation": [0, 0.45, 0], "velocity": [0.05, 0, 0]}
  ]
})";

TEST(CheckInside, TellsWhatIsHeldAndHowDeepWhatTouches) {
  const TestFolder folder;
  write_limbs(folder);
  write_text(folder / "leaving.json", kLeaving);
  const Ended run = run_pelt(folder, {"check", "leaving.json", "--inside", "--jsonl", "-"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("inside     one is held whole in frames 0"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("deepest    a vertex of two 1 is 0."), std::string::npos) << run.err;
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
      const json& q = pair["b_in_a"]["nearest"];
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

TEST(CheckInside, HasTheExitCodeOfContactWhereNothingTouches) {
  const TestFolder folder;
  write_limbs(folder);
  write_text(folder / "leaving.json", kLeaving);
  EXPECT_EQ(run_pelt(folder, {"check", "leaving.json", "--frames", "0:1"}).exit_code, 0);
  EXPECT_EQ(run_pelt(folder, {"check", "leaving.json", "--frames", "0:1", "--inside"}).exit_code,
            1);
}

TEST(CheckInside, SaysWhereNothingIsClosed) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const Ended run = run_pelt(folder, {"check", "strip.glb", "strip.glb", "--inside", "--at",
                                      "0,0,0", "--at", "9,0,0", "--frames", "0:1"});
  EXPECT_NE(run.out.find("no surface is closed"), std::string::npos) << run.out << run.err;
}

}  // namespace
}  // namespace pelt::test
