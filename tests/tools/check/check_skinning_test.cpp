/// The kind of skinning, by the scene and by the option `--skinning`.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <pelt/version.hpp>

#include <cstdlib>

namespace pelt::test {
namespace {

/// The limbs' scene with these models.
void write_scene(const TestFolder& folder, const std::string& name, const std::string& one,
                 const std::string& two) {
  json scene = json::parse(read_text(folder / "scene.json"));
  scene["models"] = {{"one", json::parse(one)}, {"two", json::parse(two)}};
  write_text(folder / name, scene.dump());
}

class CheckSkinning : public ::testing::Test {
 protected:
  void SetUp() override {
    write_limbs(folder_);
    write_scene(folder_, "plain.json", R"("one.glb")", R"("two.glb")");
    write_scene(folder_, "linear.json", R"({"file": "one.glb", "skinning": "linear"})",
                R"({"file": "two.glb"})");
    write_scene(folder_, "dual.json", R"({"file": "one.glb", "skinning": "dual-quaternion"})",
                R"({"file": "two.glb", "skinning": "dual-quaternion"})");
    write_scene(folder_, "mixed.json", R"("one.glb")",
                R"({"file": "two.glb", "skinning": "dual-quaternion"})");
  }

  CheckFile check(const Words& words) { return check_pairs(folder_, 1, words); }

  static json skinning_of(const CheckFile& file) { return file.header["options"]["skinning"]; }

  TestFolder folder_;
};

TEST_F(CheckSkinning, IsThatOfTheSceneUnlessTheOptionReplacesIt) {
  const CheckFile plain = check({"plain.json"}), dual = check({"dual.json"});
  EXPECT_NE(plain.totals["hash"], dual.totals["hash"]);
  EXPECT_EQ(skinning_of(plain), "linear");
  EXPECT_EQ(skinning_of(dual), "dual-quaternion");
  for (const CheckFile& same :
       {check({"linear.json"}), check({"dual.json", "--skinning", "linear"}),
        check({"mixed.json", "--skinning", "linear"})}) {
    EXPECT_EQ(same.totals["hash"], plain.totals["hash"]);
    EXPECT_EQ(skinning_of(same), "linear");
  }
  for (const CheckFile& same :
       {check({"plain.json", "--skinning", "dual-quaternion"}),
        check({"linear.json", "--skinning"}), check({"dual.json", "--skinning", "dual-quaternion"}),
        check({"dual.json", "--method", "brute"})}) {
    EXPECT_EQ(same.totals["hash"], dual.totals["hash"]);
    EXPECT_EQ(skinning_of(same), "dual-quaternion");
  }
}

TEST_F(CheckSkinning, MayDifferBetweenModels) {
  const CheckFile mixed = check({"mixed.json"});
  EXPECT_NE(mixed.totals["hash"], check({"plain.json"}).totals["hash"]);
  EXPECT_NE(mixed.totals["hash"], check({"dual.json"}).totals["hash"]);
  EXPECT_EQ(check({"mixed.json", "--method", "brute"}).totals["hash"], mixed.totals["hash"]);
  EXPECT_EQ(check({"mixed.json", "--by", "part"}).totals["totals"]["contacts"],
            mixed.totals["totals"]["contacts"]);
  EXPECT_EQ(skinning_of(mixed), json({{"one", "linear"}, {"two", "dual-quaternion"}}));
}

TEST_F(CheckSkinning, IsNotedIfTheBaselineHadAnother) {
  run_pelt(folder_, 1, {"check", "mixed.json", "--jsonl", "then.jsonl"});
  const Ended run = run_pelt(folder_, {"check", "dual.json", "--baseline", "then.jsonl"});
  EXPECT_TRUE(contains(run.out,
                       R"(skinning was {"one":"linear","two":"dual-quaternion"} in the baseline)"
                       R"( and is "dual-quaternion" now)"));
}

TEST_F(CheckSkinning, OfPosedFilesIsThatOfTheScene) {
  const auto pose = [&](const std::vector<std::string>& words) {
    run_pelt(folder_, 0, joined({"pose", "--frame", "7", "-o", "posed.glb"}, words));
    return read_text(folder_ / "posed.glb");
  };
  EXPECT_EQ(pose({"dual.json"}), pose({"plain.json", "--skinning"}));
  EXPECT_NE(pose({"dual.json"}), pose({"plain.json"}));
  EXPECT_EQ(pose({"dual.json", "--skinning", "linear"}), pose({"plain.json"}));
}

TEST_F(CheckSkinning, IsRefusedByPlaceInTheScene) {
  write_scene(folder_, "bad.json", R"({"file": "one.glb", "skinning": "dual"})", R"("two.glb")");
  const Ended run = run_pelt(folder_, 2, {"check", "bad.json"});
  EXPECT_TRUE(contains(run.err,
                       "bad.json: models.one.skinning: expected \"linear\" or "
                       "\"dual-quaternion\", found \"dual\""));
}

/// Joints with scale are refused by dual quaternion skinning, and the message names the instance.
TEST_F(CheckSkinning, NeedsRigidJoints) {
  json scene = json::parse(read_text(folder_ / "dual.json"));
  scene["instances"][0]["scale"] = 1.5;
  write_text(folder_ / "scaled.json", scene.dump());
  const Ended run = run_pelt(folder_, 2, {"check", "scaled.json"});
  EXPECT_TRUE(contains(run.err, "instances[0]: palette[0] is not rigid"));
}

TEST_F(CheckSkinning, OfThePageIsThatOfTheSceneAndOfTheOption) {
  const ViewerPage viewer(folder_);
  const auto reading = [&](const Words& words) {
    run_pelt(folder_, 1, joined({"check", "--html", "report.html"}, words));
    return data_of(read_text(folder_ / "report.html"))["reading"];
  };
  EXPECT_FALSE(reading({"dual.json"}).contains("skinning"));
  EXPECT_EQ(reading({"plain.json", "--skinning"})["skinning"], "dual-quaternion");
  EXPECT_EQ(reading({"dual.json", "--skinning", "linear"})["skinning"], "linear");
}

}  // namespace
}  // namespace pelt::test
