/// `pelt bounds`, compared with the positions that `pelt pose` writes.

#include "tools/answer.hpp"
#include "tools/glb_file.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

CheckFile bounds_of(const TestFolder& folder, const Words& words) {
  return answer_of(folder, 0, joined({"bounds"}, words));
}

/// The box of a mesh's triangles, in the format of the file.
json box_of(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  Vec3 low = positions[triangles[0][0]], high = low;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t v : triangle) {
      const Vec3& p = positions[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return {{"low", {low.x, low.y, low.z}}, {"high", {high.x, high.y, high.z}}};
}

bool encloses(const json& box, const json& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box["low"][axis] > inner["low"][axis] || box["high"][axis] < inner["high"][axis])
      return false;
  }
  return true;
}

json united(json a, const json& b) {
  for (int axis = 0; axis < 3; ++axis) {
    a["low"][axis] = std::min(a["low"][axis].get<float>(), b["low"][axis].get<float>());
    a["high"][axis] = std::max(a["high"][axis].get<float>(), b["high"][axis].get<float>());
  }
  return a;
}

bool encloses(const json& sphere, std::span<const Vec3> positions) {
  const json& c = sphere["centre"];
  return std::all_of(positions.begin(), positions.end(), [&](const Vec3& p) {
    return std::hypot(double{p.x} - c[0].get<double>(), double{p.y} - c[1].get<double>(),
                      double{p.z} - c[2].get<double>()) <= sphere["radius"].get<double>();
  });
}

TEST(BoundsVerb, EnclosesWhatPoseWrites) {
  const LimbsFolder folder;
  const CheckFile exact = bounds_of(folder, {"scene.json", "--exact"});
  const CheckFile guaranteed = bounds_of(folder, {"scene.json"});
  EXPECT_EQ(exact.header["format"], "pelt-bounds");
  ASSERT_EQ(exact.frames.size(), 12u);
  ASSERT_EQ(guaranteed.frames.size(), 12u);
  for (const int frame : {0, 5, 11}) {
    run_pelt(folder, {"pose", "scene.json", "--frame", std::to_string(frame), "-o", "posed.glb"});
    const GlbFile posed(read_text(folder / "posed.glb"));
    for (int i = 0; i < 2; ++i) {
      const json& found = exact.frames[frame]["bounds"][i];
      const json& sure = guaranteed.frames[frame]["bounds"][i];
      EXPECT_EQ(found["index"], i);
      EXPECT_EQ(found["box"], box_of(posed.positions(i), posed.triangles(i)));
      EXPECT_TRUE(encloses(sure["box"], found["box"]));
      EXPECT_NE(sure["box"], found["box"]);
      EXPECT_TRUE(encloses(found["sphere"], posed.positions(i)));
      EXPECT_TRUE(encloses(sure["sphere"], posed.positions(i)));
    }
  }
}

TEST(BoundsVerb, TotalsAreOfAllFrames) {
  const LimbsFolder folder;
  const CheckFile file = bounds_of(folder, {"scene.json", "--frames", "2:9:3"});
  ASSERT_EQ(file.frames.size(), 3u);
  EXPECT_EQ(file.totals["totals"]["frames"], 3);
  for (int i = 0; i < 2; ++i) {
    json all = file.frames[0]["bounds"][i]["box"];
    for (const json& frame : file.frames) all = united(all, frame["bounds"][i]["box"]);
    EXPECT_EQ(file.totals["totals"]["bounds"][i]["box"], all);
  }
  EXPECT_GT(file.totals["counters"]["refits"], 0);
}

TEST(BoundsVerb, PartsAndJointsTogetherAreTheInstance) {
  const StripFolder folder;
  const std::vector<std::string> scene = {"strip.glb", "--clip", "bend",
                                          "--frames",  "11:12",  "--exact"};
  const auto boxes_by = [&](const std::string& by) {
    Words arguments = scene;
    arguments.insert(arguments.end(), {"--by", by});
    return bounds_of(folder, arguments).frames[0]["bounds"];
  };
  const json instance = boxes_by("instance"), parts = boxes_by("part"), joints = boxes_by("joint");
  ASSERT_EQ(parts.size(), 2u);
  ASSERT_EQ(instance.size(), 1u);
  EXPECT_EQ(united(parts[0]["box"], parts[1]["box"]), instance[0]["box"]);
  ASSERT_GE(joints.size(), 2u);
  EXPECT_EQ(joints[0]["joint"], "lower");
  json all = joints[0]["box"];
  for (const json& joint : joints) all = united(all, joint["box"]);
  EXPECT_EQ(all, instance[0]["box"]);
}

TEST(BoundsVerb, SummaryNamesWhatIsBounded) {
  const LimbsFolder folder;
  write_strip(folder, "strip.glb");
  const Ended limbs = run_pelt(folder, {"bounds", "scene.json"});
  for (const char* words : {"2 instances", "guaranteed, in 12 frames", "one 0", "two 1", "radius"})
    EXPECT_TRUE(contains(limbs.out, words));
  const Ended joints = run_pelt(folder, {"bounds", "strip.glb", "--by", "joint", "--exact"});
  for (const char* words : {"exact, in 1 frame", "strip 0 lower"})
    EXPECT_TRUE(contains(joints.out, words));
}

}  // namespace
}  // namespace pelt::test
