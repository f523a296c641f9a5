/// The data that `pelt check --html` writes into the page. The page itself is tested in a browser
/// (viewer/test).

#include <pelt/version.hpp>

#include "tools/answer.hpp"
#include "tools/pelt/page/page_data.hpp"
#include "tools/test_scenes.hpp"

#include <algorithm>
#include <cstdlib>

namespace pelt::test {
namespace {

/// A folder with the limbs' scene and a page that replaces the viewer.
class CheckHtml : public ::testing::Test {
 protected:
  void SetUp() override {
    write_limbs(folder_);
    write_text(folder_ / "viewer.html", viewer_page(PELT_VERSION));
    ASSERT_EQ(setenv("PELT_VIEWER", (folder_ / "viewer.html").c_str(), 1), 0);
  }
  void TearDown() override { unsetenv("PELT_VIEWER"); }

  /// The text between the tags.
  static json data_of(const std::string& page) {
    const std::string open = R"(id="pelt-data">)";
    const std::size_t begin = page.find(open) + open.size();
    return json::parse(page.substr(begin, page.find("</script>") - begin));
  }

  TestFolder folder_;
};

/// RFC 4648, decoding; the command only encodes.
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
  EXPECT_EQ(data["pelt"], PELT_VERSION);
  EXPECT_EQ(data["title"], "scene.json");
  EXPECT_EQ(data["made"].get<std::string>().size(), std::string("2026-11-22T14:05:09Z").size());
  for (const auto& [key, value] : file.totals.items()) EXPECT_EQ(data["answer"][key], value) << key;
  EXPECT_EQ(data["answer"]["options"], file.header["options"]);
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

TEST_F(CheckHtml, HasTheStepsWithContactsBetweenTheirFrames) {
  const Ended run = run_pelt(folder_, {"check", "scene.json", "--between", "--fps", "3", "--html",
                                       "report.html", "--pairs", "--jsonl", "answer.jsonl"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const std::string page = read_text(folder_ / "report.html");
  CheckFile file = parse_check_file(read_text(folder_ / "answer.jsonl"));
  const std::vector<json> lines = take_steps(file);
  const json steps = data_of(page)["answer"]["steps"];
  ASSERT_GT(lines.size(), 0u);
  ASSERT_EQ(steps.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const char* key : {"step", "to", "only_between", "first"})
      EXPECT_EQ(steps[i][key], lines[i][key]) << key;
    const double begin = lines[i]["time"], end = lines[i]["end_time"], first = lines[i]["first"];
    EXPECT_NEAR(steps[i]["share"].get<double>(), (first - begin) / (end - begin), 1e-6);
    const json& pair = lines[i]["pairs"][0];
    EXPECT_EQ(steps[i]["a"], pair["a"]);
    EXPECT_EQ(steps[i]["b"], pair["b"]);
    EXPECT_EQ(steps[i]["of_self"], false);
    EXPECT_TRUE(std::any_of(pair["between"].begin(), pair["between"].end(), [&](const json& c) {
      return c["triangles"] == steps[i]["triangles"] && c["first"] == first;
    }));
  }
  const json between = file.totals["totals"]["between"];
  const std::string words = " contacts in " + between["steps_in_contact"].dump() + " of " +
                            between["steps"].dump() + " steps.";
  EXPECT_NE(page.find(words), std::string::npos);
}

TEST_F(CheckHtml, HasNoStepsWithoutBetween) {
  const Ended run = run_pelt(folder_, {"check", "scene.json", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  EXPECT_TRUE(data_of(read_text(folder_ / "report.html"))["answer"]["steps"].is_null());
}

TEST_F(CheckHtml, ShowsTheResultWithoutTheScript) {
  const Ended run =
      run_pelt(folder_, {"check", "scene.json", "--frames", "2:12:2", "--html", "a<b&c.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const std::string page = read_text(folder_ / "a<b&c.html");
  const json totals = data_of(page)["answer"]["totals"];
  EXPECT_EQ(totals["frames"], 5);
  EXPECT_GT(totals["contacts"], 0);
  const auto words = [&](const char* key) { return totals[key].dump(); };
  const std::string result = "Check failed: " + words("frames_in_contact") +
                             " of 5 frames in contact, " + words("contacts") + " contacts.";
  EXPECT_NE(page.find(R"(<p id="pelt-verdict">)" + result), page.npos) << page.substr(0, 400);
  EXPECT_NE(page.find("a&lt;b&amp;c.html"), page.npos);
}

/// Writes the files of a page to `again` and checks their scene.
CheckFile check_again(const TestFolder& folder, const json& data) {
  for (const auto& [path, bytes] : data["files"].items()) {
    const std::filesystem::path target = folder / ("again/" + path);
    std::filesystem::create_directories(target.parent_path());
    write_text(target, decode(bytes));
  }
  const std::string scene = "again/" + data["scene"].get<std::string>();
  return parse_check_file(run_pelt(folder, {"check", scene, "--jsonl", "-"}).out);
}

/// A .gltf file of the limb with its buffer, an unused buffer, a missing one, and an image.
void write_limb_of_files(const TestFolder& folder, const std::string& name,
                         const std::string& buffer) {
  GltfBuilder limb = build_limb(24);
  limb.document["buffers"] = {{{"byteLength", limb.binary.size()}, {"uri", buffer}},
                              {{"byteLength", 3}, {"uri", "unused.bin"}},
                              {{"byteLength", 3}, {"uri", "missing.bin"}}};
  limb.document["bufferViews"].push_back({{"buffer", 2}, {"byteLength", 3}});
  limb.document["images"] = {{{"uri", "../skin.png"}}};
  write_text(folder / name, limb.document.dump());
  write_bytes(folder / "limb a.bin", limb.binary);
  write_text(folder / "unused.bin", "123");
}

TEST_F(CheckHtml, EmbedsTheBuffersThatTheGeometryUses) {
  write_limb_of_files(folder_, "limb.gltf", "limb%20a.bin");
  const Ended run = run_pelt(folder_, {"check", "limb.gltf", "two.glb", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html"));
  std::set<std::string> paths;
  for (const auto& [path, bytes] : data["files"].items()) paths.insert(path);
  EXPECT_EQ(paths, (std::set<std::string>{"0/limb.glb", "1/two.glb", "scene.json"}));
  EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
}

TEST_F(CheckHtml, EmbedsALinkedBufferByItsOwnName) {
  write_limb_of_files(folder_, "limb.gltf", "link.bin");
  std::filesystem::create_symlink("limb a.bin", folder_ / "link.bin");
  const Ended run = run_pelt(folder_, {"check", "limb.gltf", "two.glb", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html"));
  EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
}

TEST_F(CheckHtml, EmbedsModelsWhoseNamesAreNotUtf8) {
  for (const char* name : {"one\xff.glb", "one\xfe.glb"})
    std::filesystem::copy_file(folder_ / "one.glb", folder_ / name);
  const Ended run =
      run_pelt(folder_, {"check", "one\xff.glb", "one\xfe.glb", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html"));
  EXPECT_EQ(data["inputs"][0]["file"], "0/model.glb");
  EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
}

TEST_F(CheckHtml, EmbedsABufferWhoseNameIsNotUtf8) {
  write_limb_of_files(folder_, "limb.gltf", "limb%FF.bin");
  std::filesystem::copy_file(folder_ / "limb a.bin", folder_ / "limb\xff.bin");
  const Ended run = run_pelt(folder_, {"check", "limb.gltf", "two.glb", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html"));
  EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
}

/// 2 MB each of an image in the binary chunk, a data URI, and extras.
TEST_F(CheckHtml, IsSmallWhateverTheLooksOfAModel) {
  constexpr std::size_t kSize = 2'000'000;
  const auto size_with = [&](const GltfBuilder& limb) {
    write_bytes(folder_ / "limb.glb", limb.glb());
    write_bytes(folder_ / "limb.gltf", limb.gltf());
    const Ended run =
        run_pelt(folder_, {"check", "limb.glb", "limb.gltf", "--html", "report.html"});
    EXPECT_EQ(run.exit_code, 1) << run.err;
    const json data = data_of(read_text(folder_ / "report.html"));
    EXPECT_EQ(data["inputs"][0]["bytes"], std::filesystem::file_size(folder_ / "limb.glb"));
    EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
    return std::filesystem::file_size(folder_ / "report.html");
  };
  GltfBuilder limb = build_limb(24);
  const std::uintmax_t plain = size_with(limb);
  limb.document["images"] = {{{"bufferView", limb.add_view(std::vector<std::byte>(kSize))}},
                             {{"uri", "data:image/png;base64," + std::string(kSize, 'A')}}};
  limb.document["extras"] = std::string(kSize, 'x');
  EXPECT_LT(size_with(limb), plain + 1000);
}

TEST_F(CheckHtml, ShowsWhatIsIgnoredAndWhatIsWorse) {
  const auto check = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"check", "scene.json", "--by", "part"});
    return run_pelt(folder_, words);
  };
  ASSERT_EQ(check({"--ignore", "one/*,two/*", "--jsonl", "known.jsonl"}).exit_code, 0);
  ASSERT_EQ(
      check({"--ignore", "one/*,two/joint 1", "--baseline", "known.jsonl", "--html", "report.html"})
          .exit_code,
      1);
  const json data = data_of(read_text(folder_ / "report.html"));
  const json& answer = data["answer"];
  EXPECT_EQ(answer["options"]["by"], "part");
  EXPECT_GT(answer["totals"]["ignored"], 0);
  EXPECT_TRUE(answer["verdict"]["failed"]);
  EXPECT_EQ(answer["verdict"]["worse"].size(), answer["touches"].size());
  const json scene = json::parse(decode(data["files"]["scene.json"]));
  EXPECT_EQ(scene["ignore"], json::array({json::array({"one/*", "two/joint 1"})}));
}

TEST_F(CheckHtml, AsksThePageForTheSameContactsOfCharactersWithThemselves) {
  const auto scene_with = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"check", "scene.json", "--html", "report.html"};
    words.insert(words.end(), options.begin(), options.end());
    const Ended run = run_pelt(folder_, words);
    EXPECT_LE(run.exit_code, 1) << run.err;
    const json data = data_of(read_text(folder_ / "report.html"));
    EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
    EXPECT_EQ(check_again(folder_, data).header["options"]["self"],
              data["answer"]["options"]["self"]);
    return json::parse(decode(data["files"]["scene.json"]));
  };
  const auto says = [&](const char* sentence) {
    return read_text(folder_ / "report.html").find(sentence) != std::string::npos;
  };
  EXPECT_EQ(scene_with({})["self"], false);
  EXPECT_FALSE(says("contacts. Only") || says("with themselves count, too."));
  const json only = scene_with({"--self=only", "--self-rings", "0", "--self-near-joints", "keep"});
  EXPECT_EQ(only["self"], "only");
  EXPECT_TRUE(says(" contacts. Only contacts of characters with themselves count. Command:"));
  EXPECT_EQ(only["self_rings"], 0);
  EXPECT_EQ(only["self_always"], "keep");
  EXPECT_EQ(only["self_near_joints"], "keep");
  EXPECT_EQ(scene_with({"--self", "--self-always", "0.5"})["self_always"], 0.5);
  EXPECT_TRUE(says(" contacts. Contacts of characters with themselves count, too. Command:"));
}

TEST_F(CheckHtml, NamesItsInputsAsTheyWereGiven) {
  std::filesystem::create_directory(folder_ / "models");
  write_bytes(folder_ / "models/one.glb", swaying_limb(24));
  ASSERT_EQ(run_pelt(folder_, {"check", "models/one.glb", "two.glb", "--html", "report.html",
                               "--jsonl", "answer.jsonl"})
                .exit_code,
            1);
  const json data = data_of(read_text(folder_ / "report.html"));
  EXPECT_EQ(data["title"], "one.glb, two.glb");
  const json& inputs = data["inputs"];
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[0]["path"], "models/one.glb");
  EXPECT_EQ(inputs[0]["file"], "0/one.glb");
  EXPECT_EQ(inputs[0]["bytes"], std::filesystem::file_size(folder_ / "models/one.glb"));
  const CheckFile file = parse_check_file(read_text(folder_ / "answer.jsonl"));
  EXPECT_EQ(inputs[1]["hash"], file.header["inputs"][1]["hash"]);
}

TEST_F(CheckHtml, EmbedsModelsOfTheCommandLine) {
  const Ended run = run_pelt(folder_, {"check", "one.glb", "two.glb", "--clip", "sway", "--clip",
                                       "sway", "--at", "0,0,0", "--html", "report.html"});
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html"));
  EXPECT_TRUE(data["files"].contains("0/one.glb"));
  EXPECT_TRUE(data["files"].contains("1/two.glb"));
  EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
}

TEST_F(CheckHtml, EmbedsTheBuffersOfAGltfFile) {
  const GltfBuilder strip = strip_with_fan();
  write_bytes(folder_ / "strip.bin", strip.binary);
  for (const std::string name : {"strip.gltf", "STRIP.GLTF"}) {
    write_bytes(folder_ / name, strip.gltf("strip.bin"));
    const Ended run =
        run_pelt(folder_, {"check", name, name, "--at", "9,0,0", "--html", "report.html"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const json data = data_of(read_text(folder_ / "report.html"));
    EXPECT_EQ(data["files"].size(), 2u);
    EXPECT_TRUE(data["files"].contains("0/" + name.substr(0, 5) + ".glb"));
    EXPECT_EQ(check_again(folder_, data).totals["hash"], data["answer"]["hash"]);
  }
}

TEST_F(CheckHtml, RefusesAFileThatHasChangedMeanwhile) {
  const auto scene = scenes::load_scene(folder_ / "scene.json");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(tools::page::read_character_files(*scene));
  write_bytes(folder_ / "two.glb", swaying_limb(16));
  const auto files = tools::page::read_character_files(*scene);
  ASSERT_FALSE(files);
  EXPECT_NE(files.error().message.find("two.glb: was changed"), std::string::npos);
}

TEST_F(CheckHtml, TellsThePageTheClearance) {
  const Ended run =
      run_pelt(folder_, {"check", "scene.json", "--html", "report.html", "--clearance", "0.25"});
  EXPECT_LE(run.exit_code, 1) << run.err;
  const std::string page = read_text(folder_ / "report.html");
  EXPECT_NE(page.find(" contacts (triangles at most 0.25 apart). Command:"), std::string::npos);
  const json data = data_of(page);
  EXPECT_EQ(data["answer"]["options"]["clearance"], 0.25);
  EXPECT_EQ(json::parse(decode(data["files"]["scene.json"]))["self"], false);
}

TEST_F(CheckHtml, TellsThePageTheLimitOfContacts) {
  const Ended run =
      run_pelt(folder_, {"check", "scene.json", "--html", "report.html", "--max-contacts", "3"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const std::string page = read_text(folder_ / "report.html");
  EXPECT_NE(page.find(" contacts, at most 3 of each pair in each frame. Command:"),
            std::string::npos);
  const json answer = data_of(page)["answer"];
  EXPECT_EQ(answer["options"]["max_contacts"], 3);
  EXPECT_EQ(answer["hash"], nullptr);
  for (const json& count : answer["counts"]) EXPECT_LE(count, 3);
}

TEST_F(CheckHtml, TellsThePageTheBudget) {
  const Ended run =
      run_pelt(folder_, {"check", "scene.json", "--html", "report.html", "--budget", "500"});
  EXPECT_LE(run.exit_code, 1) << run.err;
  const std::string page = read_text(folder_ / "report.html");
  const json answer = data_of(page)["answer"];
  EXPECT_EQ(answer["options"]["budget"], 500);
  EXPECT_EQ(answer["hash"], nullptr);
  const auto frames = answer["totals"]["unknown"]["frames"].get<int>();
  EXPECT_GT(frames, 0);
  EXPECT_NE(page.find(" The budget did not suffice: more contacts are possible in " +
                      std::to_string(frames) + " frames. Command:"),
            std::string::npos);
}

TEST_F(CheckHtml, TellsThePageTheFramesOfAllClips) {
  write_strip(folder_, "strip.glb");
  const std::vector<std::string> words = {"check",  "strip.glb", "--by",   "part",
                                          "--clip", "*",         "--html", "report.html"};
  const Ended run = run_pelt(folder_, words);
  ASSERT_EQ(run.exit_code, 1) << run.err;
  const json data = data_of(read_text(folder_ / "report.html")), &clips = data["clips"];
  ASSERT_EQ(clips.size(), 2u);
  EXPECT_EQ(clips[1]["first_frame"], clips[0]["frames"]);
  EXPECT_EQ(clips[1]["first_frame"].get<std::size_t>() + clips[1]["frames"].get<std::size_t>(),
            data["answer"]["counts"].size());
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(clips[i]["clip"], data["answer"]["options"]["clips"][i]);
}

TEST_F(CheckHtml, RefusesAllClipsWithAShareOfTheirFrames) {
  write_strip(folder_, "strip.glb");
  const Ended run = run_pelt(folder_, {"check", "strip.glb", "--clip", "*", "--html", "report.html",
                                       "--self-always", "0.9"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--html: cannot be combined with --self-always and all clips ('*'): leave "
                         "out --self-always, or name one clip"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
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
  write_text(folder_ / "viewer.html", viewer_page("0.0.9"));
  setenv("PELT_VIEWER", (folder_ / "viewer.html").c_str(), 1);
  const Ended old = run_pelt(folder_, {"check", "scene.json", "--html", "report.html"});
  EXPECT_EQ(old.exit_code, 2);
  EXPECT_NE(old.err.find("is the page of another version"), std::string::npos) << old.err;
}

}  // namespace
}  // namespace pelt::test
