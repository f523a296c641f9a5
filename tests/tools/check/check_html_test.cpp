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

/// A folder with the limbs' scene and a page that replaces the viewer.
class CheckHtml : public ::testing::Test {
 protected:
  /// The data of the page that a check writes.
  json report(const Words& words, int exit_code = 1) {
    run_pelt(folder_, exit_code, joined(joined({"check"}, words), {"--html", "report.html"}));
    return data_of(page());
  }

  /// The same, and expects that a check of the page's files finds the same contacts.
  json whole_report(const Words& words, int exit_code = 1) {
    json data = report(words, exit_code);
    EXPECT_EQ(check_again(data).totals["hash"], data["answer"]["hash"]);
    return data;
  }

  std::string page() const { return read_text(folder_ / "report.html"); }

  /// Writes the files of a page to `again` and checks their scene.
  CheckFile check_again(const json& data, const Words& options = {}) {
    for (const auto& [path, bytes] : data["files"].items()) {
      const std::filesystem::path target = folder_ / ("again/" + path);
      std::filesystem::create_directories(target.parent_path());
      write_text(target, decode(bytes));
    }
    const Words scene = {"check", "again/" + data["scene"].get<std::string>(), "--jsonl", "-"};
    return parse_check_file(run_pelt(folder_, joined(scene, options)).out);
  }

  const LimbsFolder folder_;
  const ViewerPage viewer_{folder_};
};

TEST_F(CheckHtml, HasAllThatThePageNeedsToAnswerAgain) {
  const json data = report({"scene.json", "--frames", "2:12:2", "--jsonl", "answer.jsonl"});
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
  EXPECT_EQ(data["scene"], "scene.json");
  EXPECT_EQ(check_again(data, {"--frames", "2:12:2"}).totals["hash"], file.totals["hash"]);
}

TEST_F(CheckHtml, HasTheStepsWithContactsBetweenTheirFrames) {
  const json data =
      report({"scene.json", "--between", "--fps", "3", "--pairs", "--jsonl", "answer.jsonl"});
  CheckFile file = parse_check_file(read_text(folder_ / "answer.jsonl"));
  const std::vector<json> lines = take_steps(file);
  const json steps = data["answer"]["steps"];
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
  EXPECT_TRUE(contains(page(), words));
}

TEST_F(CheckHtml, HasNoStepsWithoutBetween) {
  EXPECT_TRUE(report({"scene.json"})["answer"]["steps"].is_null());
}

TEST_F(CheckHtml, ShowsTheResultWithoutTheScript) {
  run_pelt(folder_, 1, {"check", "scene.json", "--frames", "2:12:2", "--html", "a<b&c.html"});
  const std::string page = read_text(folder_ / "a<b&c.html");
  const json totals = data_of(page)["answer"]["totals"];
  EXPECT_EQ(totals["frames"], 5);
  EXPECT_GT(totals["contacts"], 0);
  const auto words = [&](const char* key) { return totals[key].dump(); };
  const std::string result = "Check failed: " + words("frames_in_contact") +
                             " of 5 frames in contact, " + words("contacts") + " contacts.";
  EXPECT_TRUE(contains(page, R"(<p id="pelt-verdict">)" + result)) << page.substr(0, 400);
  EXPECT_TRUE(contains(page, "a&lt;b&amp;c.html"));
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
  const json data = whole_report({"limb.gltf", "two.glb"});
  std::set<std::string> paths;
  for (const auto& [path, bytes] : data["files"].items()) paths.insert(path);
  EXPECT_EQ(paths, (std::set<std::string>{"0/limb.glb", "1/two.glb", "scene.json"}));
}

TEST_F(CheckHtml, EmbedsALinkedBufferByItsOwnName) {
  write_limb_of_files(folder_, "limb.gltf", "link.bin");
  std::filesystem::create_symlink("limb a.bin", folder_ / "link.bin");
  whole_report({"limb.gltf", "two.glb"});
}

TEST_F(CheckHtml, EmbedsModelsWhoseNamesAreNotUtf8) {
  for (const char* name : {"one\xff.glb", "one\xfe.glb"})
    std::filesystem::copy_file(folder_ / "one.glb", folder_ / name);
  const json data = whole_report({"one\xff.glb", "one\xfe.glb"});
  EXPECT_EQ(data["inputs"][0]["file"], "0/model.glb");
}

TEST_F(CheckHtml, EmbedsABufferWhoseNameIsNotUtf8) {
  write_limb_of_files(folder_, "limb.gltf", "limb%FF.bin");
  std::filesystem::copy_file(folder_ / "limb a.bin", folder_ / "limb\xff.bin");
  whole_report({"limb.gltf", "two.glb"});
}

/// 2 MB each of an image in the binary chunk, a data URI, and extras.
TEST_F(CheckHtml, IsSmallWhateverTheLooksOfAModel) {
  constexpr std::size_t kSize = 2'000'000;
  const auto size_with = [&](const GltfBuilder& limb) {
    write_bytes(folder_ / "limb.glb", limb.glb());
    write_bytes(folder_ / "limb.gltf", limb.gltf());
    const json data = whole_report({"limb.glb", "limb.gltf"});
    EXPECT_EQ(data["inputs"][0]["bytes"], std::filesystem::file_size(folder_ / "limb.glb"));
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
  const Words check = {"scene.json", "--by", "part", "--ignore"};
  report(joined(check, {"one/*,two/*", "--jsonl", "known.jsonl"}), 0);
  const json data = report(joined(check, {"one/*,two/joint 1", "--baseline", "known.jsonl"}));
  const json& answer = data["answer"];
  EXPECT_EQ(answer["options"]["by"], "part");
  EXPECT_GT(answer["totals"]["ignored"], 0);
  EXPECT_TRUE(answer["verdict"]["failed"]);
  EXPECT_EQ(answer["verdict"]["worse"].size(), answer["touches"].size());
  const json scene = json::parse(decode(data["files"]["scene.json"]));
  EXPECT_EQ(scene["ignore"], json::array({json::array({"one/*", "two/joint 1"})}));
}

TEST_F(CheckHtml, AsksThePageForTheSameContactsOfCharactersWithThemselves) {
  const auto scene_with = [&](const Words& options, int exit_code = 1) {
    const json data = whole_report(joined({"scene.json"}, options), exit_code);
    EXPECT_EQ(check_again(data).header["options"]["self"], data["answer"]["options"]["self"]);
    return json::parse(decode(data["files"]["scene.json"]));
  };
  EXPECT_EQ(scene_with({})["self"], false);
  EXPECT_FALSE(contains(page(), "contacts. Only"));
  EXPECT_FALSE(contains(page(), "with themselves count, too."));
  const json only =
      scene_with({"--self=only", "--self-rings", "0", "--self-near-joints", "keep"}, 0);
  EXPECT_EQ(only["self"], "only");
  EXPECT_TRUE(
      contains(page(), " contacts. Only contacts of characters with themselves count. Command:"));
  EXPECT_EQ(only["self_rings"], 0);
  EXPECT_EQ(only["self_always"], "keep");
  EXPECT_EQ(only["self_near_joints"], "keep");
  EXPECT_EQ(scene_with({"--self", "--self-always", "0.5"})["self_always"], 0.5);
  EXPECT_TRUE(
      contains(page(), " contacts. Contacts of characters with themselves count, too. Command:"));
}

TEST_F(CheckHtml, NamesItsInputsAsTheyWereGiven) {
  std::filesystem::create_directory(folder_ / "models");
  write_bytes(folder_ / "models/one.glb", swaying_limb(24));
  const json data = report({"models/one.glb", "two.glb", "--jsonl", "answer.jsonl"});
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
  const json data =
      whole_report({"one.glb", "two.glb", "--clip", "sway", "--clip", "sway", "--at", "0,0,0"});
  EXPECT_TRUE(data["files"].contains("0/one.glb"));
  EXPECT_TRUE(data["files"].contains("1/two.glb"));
}

TEST_F(CheckHtml, EmbedsTheBuffersOfAGltfFile) {
  const GltfBuilder strip = strip_with_fan();
  write_bytes(folder_ / "strip.bin", strip.binary);
  for (const std::string name : {"strip.gltf", "STRIP.GLTF"}) {
    write_bytes(folder_ / name, strip.gltf("strip.bin"));
    const json data = whole_report({name, name, "--at", "9,0,0"}, 0);
    EXPECT_EQ(data["files"].size(), 2u);
    EXPECT_TRUE(data["files"].contains("0/" + name.substr(0, 5) + ".glb"));
  }
}

TEST_F(CheckHtml, RefusesAFileThatHasChangedMeanwhile) {
  const auto scene = scenes::load_scene(folder_ / "scene.json");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(tools::page::read_character_files(*scene));
  write_bytes(folder_ / "two.glb", swaying_limb(16));
  const auto files = tools::page::read_character_files(*scene);
  ASSERT_FALSE(files);
  EXPECT_TRUE(contains(files.error().message, "two.glb: was changed"));
}

TEST_F(CheckHtml, TellsThePageTheClearance) {
  const json data = report({"scene.json", "--clearance", "0.25"});
  EXPECT_TRUE(contains(page(), " contacts (triangles at most 0.25 apart). Command:"));
  EXPECT_EQ(data["answer"]["options"]["clearance"], 0.25);
  EXPECT_EQ(json::parse(decode(data["files"]["scene.json"]))["self"], false);
}

TEST_F(CheckHtml, TellsThePageTheLimitOfContacts) {
  const json answer = report({"scene.json", "--max-contacts", "3"})["answer"];
  EXPECT_TRUE(contains(page(), " contacts, at most 3 of each pair in each frame. Command:"));
  EXPECT_EQ(answer["options"]["max_contacts"], 3);
  EXPECT_EQ(answer["hash"], nullptr);
  for (const json& count : answer["counts"]) EXPECT_LE(count, 3);
}

TEST_F(CheckHtml, TellsThePageTheBudget) {
  const json answer = report({"scene.json", "--budget", "500"})["answer"];
  EXPECT_EQ(answer["options"]["budget"], 500);
  EXPECT_EQ(answer["hash"], nullptr);
  const auto frames = answer["totals"]["unknown"]["frames"].get<int>();
  EXPECT_GT(frames, 0);
  EXPECT_TRUE(contains(page(), " The budget did not suffice: more contacts are possible in " +
                                   std::to_string(frames) + " frames. Command:"));
}

TEST_F(CheckHtml, TellsThePageTheFramesOfAllClips) {
  write_strip(folder_, "strip.glb");
  const json data = report({"strip.glb", "--by", "part", "--clip", "*"}), &clips = data["clips"];
  ASSERT_EQ(clips.size(), 2u);
  EXPECT_EQ(clips[1]["first_frame"], clips[0]["frames"]);
  EXPECT_EQ(clips[1]["first_frame"].get<std::size_t>() + clips[1]["frames"].get<std::size_t>(),
            data["answer"]["counts"].size());
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(clips[i]["clip"], data["answer"]["options"]["clips"][i]);
}

TEST_F(CheckHtml, RefusesAllClipsWithAShareOfTheirFrames) {
  write_strip(folder_, "strip.glb");
  const Ended run = run_pelt(
      folder_, 2,
      {"check", "strip.glb", "--clip", "*", "--html", "report.html", "--self-always", "0.9"});
  EXPECT_TRUE(contains(run.err,
                       "--html: cannot be combined with --self-always and all clips ('*'): leave "
                       "out --self-always, or name one clip"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
}

TEST_F(CheckHtml, SaysWhereTheViewerComesFrom) {
  write_text(folder_ / "viewer.html", viewer_page("0.0.9"));
  const std::pair<const char*, const char*> wrong[] = {
      {"none.html", "scripts/build-viewer"},
      {"scene.json", "scene.json: is not the viewer's page"},
      {"viewer.html", "is the page of another version"}};
  for (const auto& [viewer, message] : wrong) {
    setenv("PELT_VIEWER", (folder_ / viewer).c_str(), 1);
    const Ended run = run_pelt(folder_, 2, {"check", "scene.json", "--html", "report.html"});
    EXPECT_TRUE(contains(run.err, message));
  }
}

}  // namespace
}  // namespace pelt::test
