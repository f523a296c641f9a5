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

  CheckFile check(std::vector<std::string> words) {
    words.insert(words.begin(), "check");
    words.insert(words.end(), {"--pairs", "--jsonl", "-"});
    const Ended run = run_pelt(folder_, words);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    return parse_check_file(run.out);
  }

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
  ASSERT_EQ(run_pelt(folder_, {"check", "mixed.json", "--jsonl", "then.jsonl"}).exit_code, 1);
  const Ended run = run_pelt(folder_, {"check", "dual.json", "--baseline", "then.jsonl"});
  EXPECT_NE(run.out.find(R"(skinning was {"one":"linear","two":"dual-quaternion"} in the baseline)"
                         R"( and is "dual-quaternion" now)"),
            std::string::npos)
      << run.out << run.err;
}

TEST_F(CheckSkinning, OfPosedFilesIsThatOfTheScene) {
  const auto pose = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"pose", "--frame", "7", "-o", "posed.glb"};
    all.insert(all.end(), words.begin(), words.end());
    const Ended run = run_pelt(folder_, all);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_text(folder_ / "posed.glb");
  };
  EXPECT_EQ(pose({"dual.json"}), pose({"plain.json", "--skinning"}));
  EXPECT_NE(pose({"dual.json"}), pose({"plain.json"}));
  EXPECT_EQ(pose({"dual.json", "--skinning", "linear"}), pose({"plain.json"}));
}

TEST_F(CheckSkinning, IsRefusedByPlaceInTheScene) {
  write_scene(folder_, "bad.json", R"({"file": "one.glb", "skinning": "dual"})", R"("two.glb")");
  const Ended run = run_pelt(folder_, {"check", "bad.json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("bad.json: models.one.skinning: expected \"linear\" or "
                         "\"dual-quaternion\", found \"dual\""),
            std::string::npos)
      << run.err;
}

/// Joints with scale are refused by dual quaternion skinning, and the message names the instance.
TEST_F(CheckSkinning, NeedsRigidJoints) {
  json scene = json::parse(read_text(folder_ / "dual.json"));
  scene["instances"][0]["scale"] = 1.5;
  write_text(folder_ / "scaled.json", scene.dump());
  const Ended run = run_pelt(folder_, {"check", "scaled.json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("instances[0]: palette[0] is not rigid"), std::string::npos) << run.err;
}

TEST_F(CheckSkinning, OfThePageIsThatOfTheSceneAndOfTheOption) {
  write_text(folder_ / "viewer.html", viewer_page(PELT_VERSION));
  ASSERT_EQ(setenv("PELT_VIEWER", (folder_ / "viewer.html").c_str(), 1), 0);
  const auto data_of = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"check", "--html", "report.html"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(run_pelt(folder_, all).exit_code, 1);
    const std::string page = read_text(folder_ / "report.html");
    const std::string open = R"(id="pelt-data">)";
    const std::size_t begin = page.find(open) + open.size();
    return json::parse(page.substr(begin, page.find("</script>") - begin));
  };
  EXPECT_FALSE(data_of({"dual.json"})["reading"].contains("skinning"));
  EXPECT_EQ(data_of({"plain.json", "--skinning"})["reading"]["skinning"], "dual-quaternion");
  EXPECT_EQ(data_of({"dual.json", "--skinning", "linear"})["reading"]["skinning"], "linear");
  unsetenv("PELT_VIEWER");
}

}  // namespace
}  // namespace pelt::test
