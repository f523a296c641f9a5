/// `pelt check --clip '*'`: all clips of a model in one check.

#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

using nlohmann::json;

/// The strip with the clips "bend" (1 s) and "wave" (equal to "bend").
std::string write_moving_strip(const TestFolder& folder) {
  GltfBuilder builder = strip_with_fan();
  builder.document["animations"][1]["name"] = "wave";
  write_bytes(folder / "strip.glb", builder.glb());
  return folder / "strip.glb";
}

const std::vector<std::string> kApart = {"--at", "0,0,0", "--at", "0.25,0,0.1"};

/// A check of two strips, with `clips` for each of them and other options.
std::vector<std::string> two_strips(const std::string& strip, const std::vector<std::string>& clips,
                                    const Words& options = {}) {
  Words arguments = {"check", strip, strip};
  for (const std::string& clip : clips) arguments.insert(arguments.end(), {"--clip", clip});
  arguments.insert(arguments.end(), kApart.begin(), kApart.end());
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

/// The answer of a check that finds contacts.
CheckFile checked(const TestFolder& folder, const Words& words) {
  return answer_of(folder, 1, joined(words, {"--pairs"}));
}

TEST(CheckAllClips, FindWhatChecksOfEachClipFind) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  const CheckFile all = checked(folder, two_strips(strip, {"*", "bend"}));
  ASSERT_EQ(all.frames.size(), 60u);
  EXPECT_EQ(all.header["options"]["clips"], json({"bend", "wave"}));
  std::uint64_t contacts = 0;
  std::size_t touches = 0, first = 0;
  for (const char* clip : {"bend", "wave"}) {
    const CheckFile one = checked(folder, two_strips(strip, {clip, "bend"}));
    ASSERT_EQ(one.frames.size(), 30u);
    for (std::size_t f = 0; f < 30; ++f) {
      const json& frame = all.frames[first + f];
      EXPECT_EQ(frame["frame"], first + f);
      EXPECT_EQ(frame["clip"], clip);
      EXPECT_EQ(frame["clip_frame"], f);
      EXPECT_EQ(frame["time"], one.frames[f]["time"]);
      EXPECT_EQ(frame["pairs"], one.frames[f]["pairs"]) << clip << " " << f;
    }
    first += 30;
    contacts += one.totals["totals"]["contacts"].get<std::uint64_t>();
    touches += one.totals["touches"].size();
  }
  EXPECT_GT(contacts, 0u);
  EXPECT_EQ(all.totals["totals"]["contacts"], contacts);
  EXPECT_EQ(all.totals["touches"].size(), touches);
  for (const json& touch : all.totals["touches"]) {
    const json& worst = all.frames[touch["worst"]["frame"].get<std::size_t>()];
    EXPECT_EQ(touch["clip"], worst["clip"]);
    EXPECT_EQ(touch["worst"]["clip_frame"], worst["clip_frame"]);
  }
  ASSERT_EQ(all.totals["clips"].size(), 2u);
  EXPECT_EQ(all.totals["clips"][1]["clip"], "wave");
  EXPECT_EQ(all.totals["clips"][1]["first_frame"], 30);
  EXPECT_EQ(all.totals["clips"][1]["frames"], 30);
  EXPECT_EQ(all.totals["hash"], hash_of(all));
}

TEST(CheckAllClips, AreNamedInTheSummary) {
  const TestFolder folder;
  const Ended run =
      run_pelt(folder, 1, two_strips(write_moving_strip(folder), {"*", "-"}, {"--contacts"}));
  for (const char* words :
       {"clips      2; --frames of each: \"bend\" 0:30, \"wave\" 30:60\n", "frames: \"bend\" 0-",
        ", \"wave\" 0-", "worst      frame 0 of clip \"bend\" (0.000 s)",
        "clips      2 of 2 checked clips in contact\n",
        "  frame 0 of clip \"wave\", in contact in ", " %  \"bend\"  strip 0 ",
        " %  \"wave\"  strip 0 ", " frames, worst frame 0\n",
        "  frame 4 of clip \"bend\" (0.133 s)\n"})
    EXPECT_TRUE(contains(run.out, words)) << words << " is not in\n" << run.out;
  EXPECT_FALSE(contains(run.out, "frame 30")) << run.out;
}

TEST(CheckAllClips, CountTheFramesOfEachClipFromItsStart) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  const std::vector<std::string> late = {"--start", "0.4"};
  const CheckFile all = checked(folder, two_strips(strip, {"*", "-"}, late));
  for (const json& clip : all.totals["clips"]) {
    const json& worst = clip["worst"];
    const auto frame = worst["clip_frame"].get<std::uint32_t>();
    EXPECT_GT(frame, 0u);
    EXPECT_EQ(worst["frame"], clip["first_frame"].get<std::uint32_t>() + frame);
    const std::string range = std::to_string(frame) + ":" + std::to_string(frame + 1);
    Words words = two_strips(strip, {clip["clip"], "-"}, late);
    words.insert(words.end(), {"--frames", range});
    EXPECT_EQ(checked(folder, words).totals["totals"]["contacts"], worst["contacts"]);
  }
}

TEST(CheckAllClips, CoverTheChosenFrames) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  const CheckFile some = checked(folder, two_strips(strip, {"*"}, {"--frames", "40:44"}));
  ASSERT_EQ(some.frames.size(), 4u);
  ASSERT_EQ(some.totals["clips"].size(), 1u);
  EXPECT_EQ(some.totals["clips"][0]["clip"], "wave");
  EXPECT_EQ(some.totals["clips"][0]["frames"], 4);
  const Ended beyond = run_pelt(folder, 2, two_strips(strip, {"*"}, {"--frames", "40:61"}));
  EXPECT_TRUE(contains(beyond.err, "40:61 goes beyond the last frame")) << beyond.err;
}

TEST(CheckAllClips, WorkLikewiseInSceneFiles) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  write_text(folder / "scene.json", R"({
    "models": {"strip": "strip.glb"},
    "frames": {"fps": 10},
    "instances": [{"model": "strip", "clip": "*"},
                  {"model": "strip", "clip": "bend", "translation": [0.25, 0, 0.1]}]})");
  const CheckFile models = checked(folder, two_strips(strip, {"*", "bend"}, {"--fps", "5"}));
  const CheckFile scene = checked(folder, {"check", "scene.json", "--fps", "5"});
  EXPECT_EQ(scene.frames.size(), 10u);
  EXPECT_EQ(scene.frames, models.frames);
}

TEST(CheckAllClips, AreComparedWithABaselineClipByClip) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  const CheckFile all = checked(folder, two_strips(strip, {"*", "-"}));
  json bend = all.totals;
  std::erase_if(bend["touches"].get_ref<json::array_t&>(),
                [](const json& touch) { return touch["clip"] == "wave"; });
  ASSERT_GT(bend["touches"].size(), 0u);
  ASSERT_LT(bend["touches"].size(), all.totals["touches"].size());
  write_text(folder / "all.jsonl", all.header.dump() + "\n" + all.totals.dump() + "\n");
  write_text(folder / "bend.jsonl", all.header.dump() + "\n" + bend.dump() + "\n");
  const auto check = [&](const char* baseline) {
    return run_pelt(folder, two_strips(strip, {"*", "-"}, {"--baseline", baseline}));
  };
  EXPECT_EQ(check("all.jsonl").exit_code, 0);
  const Ended run = check("bend.jsonl");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.out, "(new)  frame 0 of clip \"wave\"  strip 0 ")) << run.out;
  EXPECT_FALSE(contains(run.out, "of clip \"bend\"  strip 0 ")) << run.out;
  const Ended one = run_pelt(folder, 2, two_strips(strip, {"bend"}, {"--baseline", "all.jsonl"}));
  EXPECT_TRUE(contains(one.err, "was written with all clips of a model")) << one.err;
}

TEST(CheckAllClips, AreRefusedWithARemedy) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  write_bytes(folder / "stone.glb", stone().glb());
  const std::string other = write_strip(folder, "other.glb");
  GltfBuilder twice = strip_with_fan();
  twice.document["animations"][1]["name"] = "bend";
  write_bytes(folder / "twice.glb", twice.glb());
  const auto refusal = [&](Words arguments) {
    const Ended run = run_pelt(folder, 2, arguments);
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_EQ(refusal({"check", "stone.glb", "--clip", "*"}),
            "pelt: error: --clip: \"stone\" has no clips, so \"*\" has nothing to play\n");
  EXPECT_TRUE(contains(refusal({"check", "twice.glb", "--clip", "*"}),
                       "--clip: \"twice\" has several clips named \"bend\""));
  EXPECT_TRUE(contains(refusal({"check", strip, other, "--clip", "*", "--clip", "*"}),
                       "--clip: \"strip\" and \"other\" have different clips"));
}

TEST(AllClips, AreNamedInTheLinesOfOtherQueries) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  const CheckFile file = answer_of(folder, 0, {"bounds", strip, "--clip", "*"});
  ASSERT_EQ(file.frames.size(), 60u);
  EXPECT_EQ(file.frames[29]["clip"], "bend");
  EXPECT_EQ(file.frames[30]["clip"], "wave");
  EXPECT_EQ(file.frames[30]["clip_frame"], 0);
  EXPECT_EQ(file.frames[30]["time"], 0);
}

/// Frames 30 to 59 are those of the second clip.
TEST(AllClips, AreNamedInTheSummariesOfOtherQueries) {
  const TestFolder folder;
  const std::string strip = write_moving_strip(folder);
  const auto run_of = [&](Words words) {
    words.insert(words.begin() + 1, {strip, strip, "--clip", "*", "--at", "0,0,0", "--at", "3,0,0",
                                     "--frames", "30:60"});
    const Ended run = run_pelt(folder, 0, words);
    return run;
  };
  EXPECT_TRUE(contains(run_of({"distance", "--from", "0,9,0"}).out, " of clip \"wave\": "));
  const Ended distances = run_of({"distance", "--jsonl", "-"});
  const json least = parse_check_file(distances.out).totals["totals"]["least"][0];
  EXPECT_EQ(least["clip"], "wave");
  EXPECT_EQ(least["frame"].get<int>(), least["clip_frame"].get<int>() + 30);
  EXPECT_TRUE(contains(distances.err, "frame " + std::to_string(least["clip_frame"].get<int>()) +
                                          " of clip \"wave\""))
      << distances.err;
  const std::string hits = run_of({"ray", "--from", "0.1,5,0.05", "--to", "0.1,-5,0.05"}).out;
  EXPECT_TRUE(contains(hits, "of 30 frames: \"wave\" ")) << hits;
  EXPECT_TRUE(contains(hits, " of clip \"wave\": ")) << hits;
  const std::string region = run_of({"region", "--sphere", "0,0,0,1"}).out;
  EXPECT_TRUE(contains(region, "not outside in \"wave\" ")) << region;
}

}  // namespace
}  // namespace pelt::test
