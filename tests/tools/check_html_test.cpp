/// What `pelt check --html` puts into the page; the page itself is tested in a browser
/// (viewer/test).

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <cstdlib>

namespace pelt::test {
namespace {

constexpr const char* kPage =
    R"(<html><script type="application/json" id="pelt-data"></script><p>viewer</p></html>)";

/// A folder with the limbs' scene and a page that stands in for the viewer.
class CheckHtml : public ::testing::Test {
 protected:
  void SetUp() override {
    write_limbs(folder_);
    write_text(folder_ / "viewer.html", kPage);
    ASSERT_EQ(setenv("PELT_VIEWER", (folder_ / "viewer.html").c_str(), 1), 0);
  }
  void TearDown() override { unsetenv("PELT_VIEWER"); }

  /// What stands between the tags.
  static json data_of(const std::string& page) {
    const std::string open = R"(id="pelt-data">)";
    const std::size_t begin = page.find(open) + open.size();
    return json::parse(page.substr(begin, page.find("</script>") - begin));
  }

  TestFolder folder_;
};

/// RFC 4648, for the other direction than the command's.
std::string decode(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

TEST_F(CheckHtml, HasAllThatThePageNeedsToAnswerAgain) {
  const Ended run = run_pelt(folder_, {"check", "scene.json", "--frames", "2:12:2", "--html",
                                       "report.html", "--jsonl", "answer.jsonl"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html"));
  const CheckFile file = parse_check_file(read_text(folder_ / "answer.jsonl"));
  EXPECT_EQ(data["format"], "pelt-report");
  EXPECT_EQ(data["command"],
            "pelt check scene.json --frames 2:12:2 --jsonl answer.jsonl --html report.html");
  EXPECT_EQ(data["answer"]["hash"], file.totals["hash"]);
  EXPECT_EQ(data["answer"]["frames"], json({2, 12, 2}));
  ASSERT_EQ(data["answer"]["counts"].size(), file.frames.size());
  for (std::size_t i = 0; i < file.frames.size(); ++i)
    EXPECT_EQ(data["answer"]["counts"][i], file.frames[i]["contacts"]);

  for (const auto& [path, bytes] : data["files"].items()) {
    const std::filesystem::path target = folder_ / ("again/" + path);
    std::filesystem::create_directories(target.parent_path());
    write_text(target, decode(bytes));
  }
  const Ended again =
      run_pelt(folder_, {"check", "again/scene.json", "--frames", "2:12:2", "--jsonl", "-"});
  EXPECT_EQ(parse_check_file(again.out).totals["hash"], file.totals["hash"]);
}

TEST_F(CheckHtml, TakesModelsOfTheCommandLine) {
  const Ended run = run_pelt(folder_, {"check", "one.glb", "two.glb", "--clip", "sway", "--clip",
                                       "sway", "--at", "0,0,0", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json files = data_of(read_text(folder_ / "report.html"))["files"];
  EXPECT_EQ(decode(files["0/one.glb"]), read_text(folder_ / "one.glb"));
  EXPECT_EQ(decode(files["1/two.glb"]), read_text(folder_ / "two.glb"));
}

TEST_F(CheckHtml, TakesTheBuffersOfAGltfFile) {
  const GltfBuilder strip = strip_with_fan();
  write_bytes(folder_ / "strip.gltf", strip.gltf("strip.bin"));
  write_bytes(folder_ / "strip.bin", strip.binary);
  const Ended run = run_pelt(
      folder_, {"check", "strip.gltf", "strip.gltf", "--at", "9,0,0", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json files = data_of(read_text(folder_ / "report.html"))["files"];
  EXPECT_EQ(files.size(), 3u);
  EXPECT_EQ(decode(files["0/strip.gltf"]), read_text(folder_ / "strip.gltf"));
  EXPECT_EQ(decode(files["0/strip.bin"]), read_text(folder_ / "strip.bin"));
}

TEST_F(CheckHtml, RefusesWhatThePageCannotShow) {
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--by", "part"},
                                                 {"--clearance", "0.1"},
                                                 {"--max-contacts", "3"},
                                                 {"--ignore", "one/*,two/*"}}) {
    std::vector<std::string> arguments = {"check", "scene.json", "--html", "report.html"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Ended run = run_pelt(folder_, arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("--html: the page does not know " + option[0]), std::string::npos)
        << run.err;
  }
}

TEST_F(CheckHtml, SaysWhereTheViewerComesFrom) {
  setenv("PELT_VIEWER", (folder_ / "none.html").c_str(), 1);
  const Ended missing = run_pelt(folder_, {"check", "scene.json", "--html", "report.html"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.err.find("scripts/build-viewer"), std::string::npos) << missing.err;
  setenv("PELT_VIEWER", (folder_ / "scene.json").c_str(), 1);
  const Ended wrong = run_pelt(folder_, {"check", "scene.json", "--html", "report.html"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("scene.json: is not the viewer's page"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace pelt::test
