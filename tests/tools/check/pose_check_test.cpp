/// The answer of `pelt check` equals brute force at the positions that `pelt pose` writes. Both
/// verbs share one definition of a posed vertex; this test uses only their files.

#include "tools/answer.hpp"
#include "tools/glb_file.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

GlbFile pose_to_file(const TestFolder& folder, const std::string& scene, const std::string& frame) {
  run_pelt(folder, 0, {"pose", scene, "--frame", frame, "-o", "posed.glb"});
  return GlbFile(read_text(folder / "posed.glb"));
}

/// The pairs of touching meshes, in the format of a frame of a pelt-check file.
json touching_pairs(const GlbFile& file) {
  const std::size_t count = file.document["meshes"].size();
  std::vector<std::vector<Triangle>> triangles;
  for (std::size_t i = 0; i < count; ++i) triangles.push_back(file.triangles(i));
  std::vector<tools::scene::PosedInstance> posed;
  for (std::size_t i = 0; i < count; ++i) posed.push_back({"", file.positions(i), triangles[i]});

  json pairs = json::array();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b) {
      const json found = brute_force_json(posed[a], posed[b]);
      if (found.empty()) continue;
      pairs.push_back({{"a", a}, {"b", b}, {"contacts", found.size()}, {"triangles", found}});
    }
  return pairs;
}

json checked_pairs(const TestFolder& folder, const std::string& scene, std::uint32_t frame) {
  const std::string frames = std::to_string(frame) + ":" + std::to_string(frame + 1);
  const Ended run =
      run_pelt(folder, {"check", scene, "--frames", frames, "--jsonl", "-", "--pairs"});
  const CheckFile file = parse_check_file(run.out);
  EXPECT_EQ(file.frames.size(), 1u) << run.err;
  return file.frames[0]["pairs"];
}

void expect_one_answer_in_both_files(const TestFolder& folder, const std::string& scene,
                                     const std::vector<std::uint32_t>& frames,
                                     std::size_t in_contact) {
  std::size_t touching = 0;
  for (const std::uint32_t frame : frames) {
    const json expected = touching_pairs(pose_to_file(folder, scene, std::to_string(frame)));
    EXPECT_EQ(checked_pairs(folder, scene, frame), expected) << "frame " << frame;
    touching += !expected.empty();
  }
  EXPECT_EQ(touching, in_contact);
}

TEST(PosedLimbs, AreCheckedWhereTheyAreWritten) {
  const LimbsFolder folder;
  expect_one_answer_in_both_files(folder, "scene.json", {0, 3, 4, 5, 6, 7, 8, 11}, 3);
}

struct Sampled {
  const char* folder;
  const char* scene;
  std::vector<std::uint32_t> frames;
  std::size_t in_contact;
};

class PosedScenes : public ::testing::TestWithParam<Sampled> {};

TEST_P(PosedScenes, AreCheckedWhereTheyAreWritten) {
  const Sampled& sampled = GetParam();
  if (!std::filesystem::exists(sampled.folder)) GTEST_SKIP() << sampled.folder << " is not there";
  const std::string scene = std::string(sampled.folder) + "/" + sampled.scene + ".json";
  expect_one_answer_in_both_files(TestFolder(), scene, sampled.frames, sampled.in_contact);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, PosedScenes,
    ::testing::Values(Sampled{PELT_SCENES_DIR, "approaching", {119}, 1},
                      Sampled{PELT_SHARED_DIR "/scenes", "two_walkers", {110, 119}, 1}),
    [](const auto& sampled) { return std::string(sampled.param.scene); });

}  // namespace
}  // namespace pelt::test
