/// The options of `pelt check`, one by one.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <pelt/asset.hpp>

namespace pelt::test {
namespace {

std::vector<json> frames_of(const Ended& run) { return parse_check_file(run.out).frames; }

TEST(CheckOptions, ExitCodeIsOneOnContact) {
  const LimbsFolder folder;
  run_pelt(folder, 0, {"check", "scene.json", "--frames", "0:1"});
  run_pelt(folder, 1, {"check", "scene.json", "--frames", "0:8"});
  run_pelt(folder, 2, {"check", "none.json"});
}

TEST(CheckOptions, StandardOutputIsForTheAnswerOrForPeople) {
  const LimbsFolder folder;
  const Ended words = run_pelt(folder, {"check", "scene.json", "--jsonl", "a.jsonl"});
  EXPECT_TRUE(contains(words.out, "joints that touch"));
  EXPECT_TRUE(contains(words.out, "wrote a.jsonl\n"));
  EXPECT_EQ(words.err, "");
  const Ended answer = run_pelt(folder, {"check", "scene.json", "--jsonl", "-"});
  EXPECT_EQ(answer.out, read_text(folder / "a.jsonl"));
  EXPECT_TRUE(contains(answer.err, "joints that touch"));
}

TEST(CheckOptions, SummaryNamesFramesPartsAndJoints) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  const Ended run = run_pelt(
      folder, 1, {"check", strip, strip, "--at", "0,0,0", "--at", "0.25,0,0.1", "--frames", "0:2"});
  for (const char* words : {"2 instances, 16 triangles", "in 2 of 2 frames: 0-1",
                            "frame 0 (0.000 s)", "parts that touch", "strip 0 paper", "strip 1 fan",
                            "strip 0 lower", "median", "node pairs", "hash"}) {
    EXPECT_TRUE(contains(run.out, words));
  }
}

TEST(CheckOptions, SummarySaysWhereThereIsNothingToTouch) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  const std::string note = "nothing can touch";
  const Ended alone = run_pelt(folder, 2, {"check", strip, "--self", "no"});
  EXPECT_TRUE(contains(alone.out, note + ": none is tested against itself; --by part"));
  const Ended parts = run_pelt(folder, {"check", strip, "--by", "part"});
  EXPECT_FALSE(contains(parts.out, note));
  const Ended two = run_pelt(folder, 0, {"check", strip, strip, "--at", "0,0,0", "--at", "9,0,0"});
  EXPECT_FALSE(contains(two.out, note));
}

TEST(CheckOptions, ModelsArePlacedAsASceneWouldPlaceThem) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  write_text(folder / "scene.json", R"({
    "models": {"strip": "strip.glb"},
    "frames": {"count": 4, "fps": 8},
    "instances": [
      {"model": "strip", "clip": "bend", "start": 0.25, "scale": 1.25},
      {"model": "strip", "clip": "", "start": -0.25, "translation": [0.5, -0.25, 0.125],
       "rotation": [0, 1, 0, 0]},
      {"model": "strip", "translation": [0, 0.5, 0]}
    ]})");
  const Ended scene = run_pelt(folder, {"check", "scene.json", "--jsonl", "-", "--pairs"});
  const Ended models = run_pelt(
      folder, {"check",    strip,     strip,     strip,     "--clip",  "bend",  "--clip",
               "",         "--clip",  "-",       "--at",    "0,0,0",   "--at",  "0.5,-.25,.125",
               "--at",     "0,0.5,0", "--start", "0.25",    "--start", "-0.25", "--turn",
               "0",        "--turn",  "180",     "--scale", "1.25",    "--fps", "8",
               "--frames", "0:4",     "--jsonl", "-",       "--pairs"});
  ASSERT_EQ(scene.exit_code, 1) << scene.err;
  ASSERT_EQ(models.exit_code, 1) << models.err;
  EXPECT_EQ(frames_of(models), frames_of(scene));
}

TEST(CheckOptions, QuarterTurnLeadsFromZToX) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  run_pelt(folder, 0, {"pose", strip, "--turn", "90", "--frame", "0", "-o", "a.glb"});
  const auto posed = asset::load_gltf(folder / "a.glb");
  ASSERT_TRUE(posed);
  // The fan's vertex at (0.5, y, 1) moves to (1, y, -0.5).
  bool found = false;
  for (const Vec3& p : posed->rest_positions) {
    found = found || (std::abs(p.x - 1) < 1e-6f && std::abs(p.z + 0.5f) < 1e-6f);
  }
  EXPECT_TRUE(found);
}

TEST(CheckOptions, ModelsRunThroughTheirLongestClip) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  const auto frame_count = [&](const Words& arguments) {
    return frames_of(run_pelt(folder, joined({"check", strip, "--jsonl", "-"}, arguments))).size();
  };
  EXPECT_EQ(frame_count({}), 1u);
  EXPECT_EQ(frame_count({"--clip", "bend"}), 30u);
  EXPECT_EQ(frame_count({"--clip", "bend", "--fps", "12.5"}), 13u);
  EXPECT_EQ(frame_count({"--clip", "bend", "--frames", "95:100"}), 5u);
}

TEST(CheckOptions, FramesKeepTheirNumbersAndTimes) {
  const LimbsFolder folder;
  const auto all = frames_of(run_pelt(folder, {"check", "scene.json", "--jsonl", "-", "--pairs"}));
  const auto some = frames_of(
      run_pelt(folder, {"check", "scene.json", "--frames", "2:12:3", "--jsonl", "-", "--pairs"}));
  ASSERT_EQ(some.size(), 4u);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i], all[2 + 3 * i]);
}

TEST(CheckOptions, FpsStretchesAScene) {
  const LimbsFolder folder;
  const auto at_6 = frames_of(run_pelt(folder, {"check", "scene.json", "--jsonl", "-"}));
  const auto at_3 =
      frames_of(run_pelt(folder, {"check", "scene.json", "--fps", "3", "--jsonl", "-"}));
  EXPECT_EQ(at_3[3]["time"], at_6[6]["time"]);
  EXPECT_EQ(at_3[3]["pairs"], at_6[6]["pairs"]);
  EXPECT_NE(at_3[3]["pairs"], at_6[3]["pairs"]);
}

TEST(CheckOptions, PartsCanBeLeftOut) {
  const StripFolder folder;
  const std::string strip = folder / "strip.glb";
  const auto triangles = [&](const Words& options) {
    return parse_check_file(run_pelt(folder, joined({"check", strip, "--jsonl", "-"}, options)).out)
        .header["instances"][0]["triangles"];
  };
  EXPECT_EQ(triangles({}), 8);
  EXPECT_EQ(triangles({"--no-unskinned"}), 6);
  EXPECT_EQ(triangles({"--exclude", "fan"}), 6);
  EXPECT_EQ(triangles({"--exclude", "paper"}), 2);
}

TEST(CheckOptions, WeightsAreRenormalisedOnDemand) {
  const TestFolder folder;
  GltfBuilder builder = strip_with_fan();
  builder.set_value(3, 0, 1.5f);
  write_bytes(folder / "off.glb", builder.glb());
  const Ended refused = run_pelt(folder, 2, {"check", "off.glb"});
  EXPECT_TRUE(contains(refused.err, "off.glb: weights of vertex 0 sum to 1.5"));
  EXPECT_TRUE(contains(refused.err, "--renormalise"));
  run_pelt(folder, 0, {"check", "off.glb", "--renormalise", "--self", "no", "--allow-empty"});
}

/// Number of triangles of the material "contact" in a file of --glb.
std::size_t glowing(const std::string& path) {
  const auto asset = asset::load_gltf(path);
  EXPECT_TRUE(asset) << asset.error().message;
  std::size_t count = 0;
  for (const asset::Part& part : asset->parts) {
    if (part.material == "contact") count += part.triangle_count;
  }
  return count;
}

std::size_t distinct_triangles(const json& frame) {
  std::set<std::pair<int, int>> distinct;  // instance, triangle
  for (const json& triangles : frame["pairs"][0]["triangles"]) {
    distinct.insert({0, triangles[0]});
    distinct.insert({1, triangles[1]});
  }
  return distinct.size();
}

TEST(CheckOptions, GlbShowsTheWorstFrameOrTheChosenOne) {
  const LimbsFolder folder;
  const Ended worst =
      run_pelt(folder, 1, {"check", "scene.json", "--glb", "worst.glb", "--jsonl", "-", "--pairs"});
  const std::vector<json> frames = frames_of(worst);
  const auto fewer = [](const json& a, const json& b) { return a["contacts"] < b["contacts"]; };
  const json& most = *std::max_element(frames.begin(), frames.end(), fewer);
  EXPECT_EQ(glowing(folder / "worst.glb"), distinct_triangles(most));

  const auto in_contact = [](const json& frame) { return frame["contacts"] > 0; };
  const json& first = *std::find_if(frames.begin(), frames.end(), in_contact);
  ASSERT_NE(first, most);
  const std::string number = std::to_string(first["frame"].get<int>());
  run_pelt(folder, {"check", "scene.json", "--glb", "first.glb", "--glb-frame", number});
  EXPECT_EQ(glowing(folder / "first.glb"), distinct_triangles(first));
}

TEST(CheckOptions, GlbWithoutContactShowsTheFirstFrame) {
  const LimbsFolder folder;
  run_pelt(folder, 0, {"check", "scene.json", "--frames", "0:1", "--glb", "a.glb"});
  EXPECT_EQ(glowing(folder / "a.glb"), 0u);
}

}  // namespace
}  // namespace pelt::test
