/// `pelt distance` and `pelt check --clearance`, compared with all pairs of triangles at the
/// positions that `pelt pose` writes.

#include "tools/answer.hpp"
#include "tools/glb_file.hpp"
#include "tools/test_scenes.hpp"

#include "base/vec3.hpp"

namespace pelt::test {
namespace {

CheckFile distances_of(const TestFolder& folder, const Words& words) {
  return answer_of(folder, 0, joined({"distance"}, words));
}

GlbFile posed_frame(const TestFolder& folder, int frame) {
  run_pelt(folder, {"pose", "scene.json", "--frame", std::to_string(frame), "-o", "posed.glb"});
  return GlbFile(read_text(folder / "posed.glb"));
}

double distance_of(const json& p, const json& q) {
  return std::hypot(p[0].get<double>() - q[0].get<double>(),
                    p[1].get<double>() - q[1].get<double>(),
                    p[2].get<double>() - q[2].get<double>());
}

/// The least distance between vertices: at least the distance, and in this scene little more.
double corner_distance(const GlbFile& file) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& p : file.positions(0)) {
    for (const Vec3& q : file.positions(1)) {
      const detail::Vec3d d = detail::Vec3d(p) - detail::Vec3d(q);
      least = std::min(least, std::sqrt(dot(d, d)));
    }
  }
  return least;
}

/// Whether a point is in the box of a triangle, as every point of the triangle is.
bool is_at(const json& point, const Triangle& triangle, std::span<const Vec3> positions) {
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, 3> values;
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3& p = positions[triangle[corner]];
      values[corner] = double{axis == 0 ? p.x : axis == 1 ? p.y : p.z};
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double x = point[axis];
    if (x < *least - 1e-6 || x > *most + 1e-6) return false;
  }
  return true;
}

TEST(DistanceVerb, ReportsWhereThePairsAreClosest) {
  const LimbsFolder folder;
  const CheckFile file = distances_of(folder, {"scene.json"});
  EXPECT_EQ(file.header["format"], "pelt-distance");
  ASSERT_EQ(file.frames.size(), 12u);
  int apart = 0;
  for (const int frame : {0, 2, 10, 11}) {
    const GlbFile posed = posed_frame(folder, frame);
    const json& pair = file.frames[frame]["pairs"][0];
    const double distance = pair["distance"];
    if (distance > 0) ++apart;
    EXPECT_LE(distance, corner_distance(posed));
    EXPECT_GE(distance, corner_distance(posed) - 0.1);
    EXPECT_NEAR(distance_of(pair["points"][0], pair["points"][1]), distance, 1e-6);
    for (int side = 0; side < 2; ++side) {
      const std::size_t triangle = pair["triangles"][side];
      EXPECT_TRUE(
          is_at(pair["points"][side], posed.triangles(side)[triangle], posed.positions(side)));
      EXPECT_EQ(pair["parts"][side], "limb");
      EXPECT_EQ(pair["joints"][side].get<std::string>().rfind("joint ", 0), 0u);
    }
  }
  EXPECT_GE(apart, 2);
}

TEST(DistanceVerb, IsZeroWhereCheckFindsContact) {
  const LimbsFolder folder;
  const CheckFile distances = distances_of(folder, {"scene.json"});
  const CheckFile contacts =
      parse_check_file(run_pelt(folder, {"check", "scene.json", "--jsonl", "-", "--pairs"}).out);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < distances.frames.size(); ++f) {
    const json& pair = distances.frames[f]["pairs"][0];
    least = std::min(least, pair["distance"].get<double>());
    EXPECT_EQ(pair["distance"] == 0, contacts.frames[f]["contacts"] > 0) << "frame " << f;
    if (pair["distance"] == 0) {
      EXPECT_EQ(pair["triangles"], contacts.frames[f]["pairs"][0]["triangles"][0]);
    }
  }
  EXPECT_EQ(least, 0);
  EXPECT_EQ(distances.totals["totals"]["least"][0]["distance"], 0);
}

TEST(DistanceVerb, LeavesOutPairsThatAreNotWithin) {
  const LimbsFolder folder;
  const CheckFile all = distances_of(folder, {"scene.json"});
  const CheckFile some = distances_of(folder, {"scene.json", "--within", "0.2"});
  std::size_t left_out = 0;
  for (std::size_t f = 0; f < all.frames.size(); ++f) {
    const json& pair = all.frames[f]["pairs"][0];
    if (pair["distance"] <= 0.2) {
      EXPECT_EQ(some.frames[f], all.frames[f]);
    } else {
      EXPECT_EQ(some.frames[f]["pairs"], json::array());
      ++left_out;
    }
  }
  EXPECT_GT(left_out, 0u);
  EXPECT_LT(left_out, 12u);
}

TEST(DistanceVerb, SummaryNamesTheClosestPlaces) {
  const LimbsFolder folder;
  write_strip(folder, "strip.glb");
  const Ended run = run_pelt(folder, {"distance", "scene.json", "--frames", "0:2"});
  for (const char* words : {"2 instances", "least distances", "frame 1", "one 0 limb (joint "})
    EXPECT_TRUE(contains(run.out, words));
  const Ended far =
      run_pelt(folder, {"distance", "scene.json", "--frames", "0:1", "--within", "0"});
  EXPECT_TRUE(contains(far.out, "nothing is within that distance"));
  const Ended alone = run_pelt(folder, {"distance", "strip.glb"});
  EXPECT_TRUE(contains(alone.out, "nothing can touch: none is tested against itself; --by part"));
  const Ended parts = run_pelt(folder, {"distance", "strip.glb", "--by", "part"});
  EXPECT_TRUE(contains(parts.out, "strip 0 fan ("));
}

TEST(DistanceVerb, ListsAsManyPairsAsTheOptionSays) {
  const StripFolder folder;
  const auto listed = [&](const std::string& rows) {
    const Ended run = run_pelt(folder, 0,
                               {"distance", "strip.glb", "strip.glb", "strip.glb", "--at", "0,0,0",
                                "--at", "0,5,0", "--at", "0,9,0", "--list", rows});
    const std::string list = run.out.substr(run.out.find("least distances"));
    std::size_t count = 0;
    for (std::size_t at = list.find("  frame 0  "); at != list.npos;
         at = list.find("  frame 0  ", at + 1))
      ++count;
    return std::pair(count, list.substr(0, list.find("\n\n")));
  };
  const auto [one, words_of_one] = listed("1");
  EXPECT_EQ(one, 1u) << words_of_one;
  EXPECT_TRUE(contains(words_of_one, "... and more: --list 2"));
  const auto [all, words_of_all] = listed("3");
  EXPECT_EQ(all, 3u) << words_of_all;
  EXPECT_FALSE(contains(words_of_all, "and more"));
}

json triangles_within(const TestFolder& folder, const std::string& clearance) {
  json frames = json::array();
  for (const json& frame :
       answer_of(folder, 1,
                 {"check", "scene.json", "--clearance", clearance, "--frames", "0:8", "--pairs"})
           .frames)
    frames.push_back(frame["pairs"].empty() ? json::array() : frame["pairs"][0]["triangles"]);
  return frames;
}

TEST(Clearance, GrowsFromTheContacts) {
  const LimbsFolder folder;
  const Ended run =
      run_pelt(folder, {"check", "scene.json", "--frames", "0:8", "--jsonl", "-", "--pairs"});
  const std::vector<json> contacts = parse_check_file(run.out).frames;
  const json zero = triangles_within(folder, "0"), near = triangles_within(folder, "0.05");
  std::size_t more = 0;
  for (std::size_t f = 0; f < contacts.size(); ++f) {
    const json& pairs = contacts[f]["pairs"];
    EXPECT_EQ(zero[f], pairs.empty() ? json::array() : pairs[0]["triangles"]);
    EXPECT_TRUE(std::includes(near[f].begin(), near[f].end(), zero[f].begin(), zero[f].end()));
    more += near[f].size() - zero[f].size();
  }
  EXPECT_GT(more, 0u);
}

TEST(Clearance, FindsAPairExactlyFromItsDistanceOn) {
  const LimbsFolder folder;
  const json pair = distances_of(folder, {"scene.json", "--frames", "2:3"}).frames[0]["pairs"][0];
  const double distance = pair["distance"];
  ASSERT_GT(distance, 0);
  const auto exit_code_within = [&](double tolerance) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", tolerance);
    return run_pelt(folder, {"check", "scene.json", "--frames", "2:3", "--clearance", text})
        .exit_code;
  };
  EXPECT_EQ(exit_code_within(distance), 1);
  EXPECT_EQ(exit_code_within(distance * (1 - 1e-12)), 0);
}

TEST(Clearance, IsNamedInHeaderAndSummary) {
  const LimbsFolder folder;
  const Ended run =
      run_pelt(folder, {"check", "scene.json", "--clearance", "0.25", "--jsonl", "-"});
  EXPECT_EQ(parse_check_file(run.out).header["options"]["clearance"], 0.25);
  EXPECT_TRUE(contains(run.err, "counts triangles at most 0.25 apart"));
}

TEST(DistanceVerb, ReportsWhatIsClosestToPoints) {
  const LimbsFolder folder;
  const CheckFile file =
      distances_of(folder, {"scene.json", "--from", "-0.5,0.5,0.4", "--from", "0,2,0"});
  EXPECT_EQ(file.header["options"]["from"].size(), 2u);
  const json from[] = {{-0.5, 0.5, 0.4}, {0, 2, 0}};
  for (const int frame : {0, 5, 11}) {
    const GlbFile posed = posed_frame(folder, frame);
    for (int p = 0; p < 2; ++p) {
      const json& points = file.frames[frame]["points"][p]["closest"];
      ASSERT_EQ(points.size(), 2u);
      for (int i = 0; i < 2; ++i) {
        const json& point = points[i];
        EXPECT_NEAR(distance_of(point["position"], from[p]), point["distance"].get<double>(), 1e-6);
        const std::size_t triangle = point["triangle"];
        EXPECT_TRUE(is_at(point["position"], posed.triangles(i)[triangle], posed.positions(i)));
        for (const Vec3& corner : posed.positions(i))
          EXPECT_LE(point["distance"].get<double>(),
                    distance_of({corner.x, corner.y, corner.z}, from[p]) + 1e-6);
      }
    }
  }
  const json& least = file.totals["totals"]["least"][1];
  for (const json& frame : file.frames)
    for (const json& point : frame["points"][1]["closest"])
      EXPECT_LE(least["distance"], point["distance"]);
}

TEST(DistanceVerb, LeavesOutPlacesThatAreNotWithin) {
  const LimbsFolder folder;
  const CheckFile file = distances_of(folder, {"scene.json", "--from", "9,0,0", "--within", "1"});
  for (const json& frame : file.frames) EXPECT_EQ(frame["points"][0]["closest"], json::array());
  EXPECT_EQ(file.totals["totals"]["least"], json::array());
}

}  // namespace
}  // namespace pelt::test
