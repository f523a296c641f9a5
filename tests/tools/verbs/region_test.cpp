/// `pelt region`, compared with the vertices of all triangles at the positions that `pelt pose`
/// writes.

#include "tools/answer.hpp"
#include "tools/glb_file.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

CheckFile regions_of(const TestFolder& folder, const Words& words) {
  return answer_of(folder, 0, joined({"region", "scene.json"}, words));
}

GlbFile frame_as_posed(const TestFolder& folder, int frame) {
  run_pelt(folder, {"pose", "scene.json", "--frame", std::to_string(frame), "-o", "posed.glb"});
  return GlbFile(read_text(folder / "posed.glb"));
}

/// The triangles whose vertices are all on that side of the plane x = 0.
std::vector<std::uint32_t> triangles_beside(const GlbFile& file, int instance, double side) {
  const std::vector<Vec3> positions = file.positions(instance);
  const std::vector<Triangle> triangles = file.triangles(instance);
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    bool all = true;
    for (const std::uint32_t v : triangles[t]) all &= side * double{positions[v].x} >= 0;
    if (all) found.push_back(t);
  }
  return found;
}

TEST(RegionVerb, ListsTheTrianglesInABox) {
  const LimbsFolder folder;
  // Everything on one side of the plane x = 0, which the limbs cross.
  const CheckFile file = regions_of(folder, {"--box", "0,-9,-9,9,9,9", "--triangles"});
  EXPECT_EQ(file.header["format"], "pelt-region");
  EXPECT_EQ(file.header["options"]["box"], json({0, -9, -9, 9, 9, 9}));
  ASSERT_EQ(file.frames.size(), 12u);
  std::map<std::string, int> placements;
  for (const int frame : {0, 3, 6, 9, 11}) {
    const GlbFile posed = frame_as_posed(folder, frame);
    for (int i = 0; i < 2; ++i) {
      const json& found = file.frames[frame]["placements"][i];
      EXPECT_EQ(found["index"], i);
      EXPECT_EQ(found["inside"], json(triangles_beside(posed, i, 1)));
      const std::size_t beyond = triangles_beside(posed, i, -1).size();
      EXPECT_GE(found["intersecting"].size() + beyond, posed.triangles(i).size());
      const bool all = found["inside"].size() == posed.triangles(i).size();
      EXPECT_EQ(found["placement"], found["intersecting"].empty() ? "outside"
                                    : all                         ? "inside"
                                                                  : "partly");
      ++placements[found["placement"]];
    }
  }
  EXPECT_EQ(placements.size(), 3u) << "each is met";
  int frames = 0;
  for (const char* name : {"outside", "partly", "inside"})
    frames += file.totals["totals"]["placements"][0][name].get<int>();
  EXPECT_EQ(frames, 12);
}

TEST(RegionVerb, AcceptsEveryKindOfRegion) {
  const LimbsFolder folder;
  const auto first = [&](const std::vector<std::string>& region) {
    const CheckFile file = regions_of(folder, region);
    return file.frames[0]["placements"][0]["placement"].get<std::string>();
  };
  EXPECT_EQ(first({"--sphere", "0,0.5,0,9"}), "inside");
  EXPECT_EQ(first({"--sphere", "-0.5,0.5,0,0.2"}), "partly");
  EXPECT_EQ(first({"--capsule", "5,0,0,5,1,0,0.1"}), "outside");
  EXPECT_EQ(first({"--camera", "-0.5,0.5,9,-0.5,0.5,0"}), "inside");
  EXPECT_EQ(first({"--camera", "-0.5,0.5,9,-0.5,0.5,10"}), "outside") << "it looks away";
  EXPECT_EQ(first({"--camera", "-0.5,0.5,9,-0.5,0.5,0", "--angle", "3", "--aspect", "1"}), "partly")
      << "from 9 units away, less than half a unit of the limb";
}

TEST(RegionVerb, WritesTheFieldOfViewOfACamera) {
  const LimbsFolder folder;
  const CheckFile given =
      regions_of(folder, {"--camera", "-0.5,0.5,9,-0.5,0.5,0", "--angle", "3", "--aspect", "1.25"});
  EXPECT_EQ(given.header["options"]["camera"], json({-0.5, 0.5, 9, -0.5, 0.5, 0}));
  EXPECT_EQ(given.header["options"]["angle"], 3);
  EXPECT_EQ(given.header["options"]["aspect"], 1.25);
  const CheckFile plain = regions_of(folder, {"--camera", "-0.5,0.5,9,-0.5,0.5,0"});
  EXPECT_EQ(plain.header["options"]["angle"], 60) << "the default";
  const CheckFile ball = regions_of(folder, {"--sphere", "0,0.5,0,9"});
  EXPECT_FALSE(ball.header["options"].contains("angle"));
}

TEST(RegionVerb, RefusesWhatIsNoRegion) {
  const LimbsFolder folder;
  const auto refusal = [&](const Words& arguments) {
    const Ended run = run_pelt(folder, 2, joined({"region", "scene.json"}, arguments));
    return run.err;
  };
  EXPECT_EQ(refusal({}),
            "pelt: error: --box: no region was given: give one with --box, --sphere, --capsule or "
            "--camera\n");
  EXPECT_EQ(refusal({"--sphere", "1,2,3"}),
            "pelt: error: --sphere: \"1,2,3\" is not 4 numbers: give numbers as in --sphere "
            "0,1,0,0.5\n");
  EXPECT_EQ(refusal({"--sphere", "1,2,3,-4"}),
            "pelt: error: --sphere: the radius is negative: give 0 or more\n");
  EXPECT_EQ(
      refusal({"--box", "1,0,0,0,1,1"}),
      "pelt: error: --box: the lowest corner is above the highest corner: give the lowest x, y "
      "and z first\n");
  EXPECT_EQ(refusal({"--camera", "1,0,0,1,0,0"}),
            "pelt: error: --camera: position and target are the same point: give another point to "
            "look at\n");
  EXPECT_EQ(refusal({"--camera", "1,0,0,1,0,1", "--angle", "180"}),
            "pelt: error: --angle: \"180\" is not allowed: give degrees between 0 and 180\n");
  EXPECT_EQ(refusal({"--sphere", "1,2,3,4", "--box", "0,0,0,1,1,1"}),
            "pelt: error: --sphere: cannot be combined with --box: give one region\n");
}

}  // namespace
}  // namespace pelt::test
