/// `pelt ray`, compared with all triangles at the positions that `pelt pose` writes.

#include "tools/answer.hpp"
#include "tools/glb_file.hpp"
#include "tools/test_scenes.hpp"

#include "base/vec3.hpp"

namespace pelt::test {
namespace {

using detail::Vec3d;

CheckFile rays_of(const TestFolder& folder, const Words& words) {
  return answer_of(folder, 0, joined({"ray"}, words));
}

struct FirstHit {
  std::uint32_t triangle = 0;
  double t = std::numeric_limits<double>::infinity();
};

/// Solves for the plane and the vertices' weights in double, which suffices away from edges.
FirstHit first_hit(const Vec3d& from, const Vec3d& direction, std::span<const Vec3> positions,
                   std::span<const Triangle> triangles) {
  FirstHit first;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Vec3d a(positions[triangles[i][0]]);
    const Vec3d ab = Vec3d(positions[triangles[i][1]]) - a,
                ac = Vec3d(positions[triangles[i][2]]) - a;
    const Vec3d normal = cross(ab, ac), at = from - a;
    const double slope = dot(normal, direction);
    const double t = -dot(normal, at) / slope;
    const double v = dot(cross(at, ac), direction) / slope;
    const double w = dot(cross(at, ab), direction) / -slope;
    const bool is_hit = v >= 0 && w >= 0 && v + w <= 1 && t >= 0 && t <= 1;
    if (is_hit && t < first.t) first = {i, t};
  }
  return first;
}

TEST(RayVerb, FindsTheFirstOfAllTriangles) {
  const LimbsFolder folder;
  const CheckFile file =
      rays_of(folder, {"scene.json", "--from", "-2,0.513,0.021", "--to", "2,0.487,0.017"});
  EXPECT_EQ(file.header["format"], "pelt-ray");
  ASSERT_EQ(file.frames.size(), 12u);
  const Vec3d from(Vec3{-2, 0.513f, 0.021f}), to(Vec3{2, 0.487f, 0.017f});
  std::size_t hits = 0;
  for (const int frame : {0, 3, 6, 11}) {
    run_pelt(folder, {"pose", "scene.json", "--frame", std::to_string(frame), "-o", "posed.glb"});
    const GlbFile posed(read_text(folder / "posed.glb"));
    const json& ray = file.frames[frame]["rays"][0];
    std::size_t found = 0;
    FirstHit first;
    json first_index;
    for (int i = 0; i < 2; ++i) {
      const FirstHit hit = first_hit(from, to - from, posed.positions(i), posed.triangles(i));
      if (!(hit.t <= 1)) continue;
      ASSERT_LT(found, ray["hits"].size());
      const json& answer = ray["hits"][found++];
      EXPECT_EQ(answer["index"], i);
      EXPECT_EQ(answer["triangle"], hit.triangle);
      EXPECT_NEAR(answer["t"].get<double>(), hit.t, 1e-6);
      EXPECT_NEAR(answer["point"][0].get<double>(), from.x + hit.t * (to.x - from.x), 1e-6);
      if (hit.t < first.t) first = hit, first_index = i;
    }
    EXPECT_EQ(ray["hits"].size(), found);
    EXPECT_EQ(ray["first"], first_index) << "frame " << frame;
    hits += found;
  }
  EXPECT_GE(hits, 4u);
}

TEST(RayVerb, NamesPartAndJoints) {
  const StripFolder folder;
  // The fan is at x = 0.5, on a node of its own.
  const CheckFile file =
      rays_of(folder, {"strip.glb", "--from", "2,1.8,0.3", "--to", "1,1.8,0.3", "--beyond",
                       "--from", "2,1.8,-0.3", "--to", "0,1.8,-0.3"});
  const json& rays = file.frames[0]["rays"];
  ASSERT_EQ(rays[0]["hits"].size(), 1u);
  const json& hit = rays[0]["hits"][0];
  EXPECT_EQ(hit["part"], "fan");
  EXPECT_EQ(hit["t"], 1.5);
  EXPECT_EQ(hit["point"][0], 0.5);
  EXPECT_EQ(hit["joints"], json::parse(R"([{"joint": "fan", "share": 1.0}])"));
  EXPECT_EQ(std::abs(hit["normal"][0].get<double>()), 1);
  EXPECT_EQ(file.totals["totals"]["frames_hit"], json::array({1, 1}));
}

TEST(RayVerb, EndsAtToUnlessItGoesBeyond) {
  const StripFolder folder;
  const std::vector<std::string> ray = {"strip.glb", "--from", "2,1.8,0.3", "--to", "1,1.8,0.3"};
  const CheckFile file = rays_of(folder, ray);
  EXPECT_EQ(file.frames[0]["rays"][0]["hits"], json::array());
  EXPECT_EQ(file.frames[0]["rays"][0]["first"], nullptr);
  EXPECT_EQ(file.totals["totals"]["frames_hit"], json::array({0}));
}

TEST(RayVerb, FacingChoosesOneSide) {
  const StripFolder folder;
  std::size_t hits = 0;
  for (const char* facing : {"front", "back"}) {
    const CheckFile file = rays_of(
        folder, {"strip.glb", "--from", "2,1.8,0.3", "--to", "0,1.8,0.3", "--facing", facing});
    hits += file.frames[0]["rays"][0]["hits"].size();
  }
  EXPECT_EQ(hits, 1u);
}

TEST(RayVerb, SummaryHasTheFirstHit) {
  const LimbsFolder folder;
  const Ended run = run_pelt(folder, 0,
                             {"ray", "scene.json", "--from", "-2,0.513,0.021", "--to",
                              "2,0.487,0.017", "--from", "0,5,0", "--to", "1,5,0"});
  for (const char* words : {"2 instances", "ray 0", "hits in 12 of 12 frames: 0-11", "first hit",
                            "one 0 limb, triangle", "ray 1      hits nothing in 12 frames"})
    EXPECT_TRUE(contains(run.out, words));
}

}  // namespace
}  // namespace pelt::test
