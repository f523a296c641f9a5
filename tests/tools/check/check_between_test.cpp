/// `pelt check --between`: what touches between frames and in neither frame.

#include "motion/moving_pair.hpp"
#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <algorithm>
#include <map>

namespace pelt::test {
namespace {

using tools::scene::PosedInstance;

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Meetings = std::map<Pair, std::pair<double, detail::FirstMeeting>>;  // seconds, features

/// Two coarse limbs that pass through each other in `frames` frames of one second.
std::string write_passing(const TestFolder& folder, const std::string& name, int frames, int fps) {
  write_bytes(folder / "one.glb", swaying_limb(4));
  write_bytes(folder / "two.glb", swaying_limb(3));
  std::string scene = kLimbsScene;
  const std::string count = R"("frames": {"count": 12, "fps": 6})";
  scene.replace(scene.find(count), count.size(),
                R"("frames": {"count": )" + std::to_string(frames) + R"(, "fps": )" +
                    std::to_string(fps) + "}");
  write_text(folder / name, scene);
  return folder / name;
}

bool boxes_meet(const detail::MovingTriangle& a, const detail::MovingTriangle& b) {
  const auto along = [](const detail::MovingTriangle& t, float Vec3::*axis) {
    std::vector<float> values;
    for (int i = 0; i < 3; ++i) {
      values.push_back(t.from[i].*axis);
      values.push_back(t.to[i].*axis);
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return std::pair(*low, *high);
  };
  for (float Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const auto [low_a, high_a] = along(a, axis);
    const auto [low_b, high_b] = along(b, axis);
    if (high_a < low_b || high_b < low_a) return false;
  }
  return true;
}

detail::MovingTriangle moving(const PosedInstance& from, const PosedInstance& to,
                              std::uint32_t triangle) {
  const Triangle& t = from.triangles[triangle];
  detail::MovingTriangle result;
  for (int i = 0; i < 3; ++i) {
    result.from[i] = from.positions[t[i]];
    result.to[i] = to.positions[t[i]];
  }
  return result;
}

/// Adds the pairs that meet in a piece from `begin` to `end` seconds, and that are not yet known.
void add_piece(const std::vector<PosedInstance>& from, const std::vector<PosedInstance>& to,
               double begin, double end, Meetings& meetings) {
  for (std::uint32_t a = 0; a < from[0].triangles.size(); ++a)
    for (std::uint32_t b = 0; b < from[1].triangles.size(); ++b) {
      const detail::MovingTriangle of_a = moving(from[0], to[0], a),
                                   of_b = moving(from[1], to[1], b);
      if (!boxes_meet(of_a, of_b)) continue;
      if (const auto met = detail::first_meeting(of_a, of_b))
        meetings.try_emplace({a, b}, begin + (end - begin) * static_cast<double>(met->time), *met);
    }
}

json feature_json(const Feature& feature) {
  constexpr const char* kNames[] = {"corner", "edge", "face"};
  json object = {{"kind", kNames[static_cast<int>(feature.kind)]}};
  if (feature.kind != FeatureKind::face) object["number"] = feature.number;
  return object;
}

/// The list of contacts between frames that is expected, without times.
json expected_list(const Meetings& meetings) {
  json list = json::array();
  for (const auto& [pair, met] : meetings)
    list.push_back({{"triangles", {pair.first, pair.second}},
                    {"features", {feature_json(met.second.a), feature_json(met.second.b)}}});
  return list;
}

json without_times(json list) {
  for (json& contact : list) contact.erase("first");
  return list;
}

class BetweenBruteForce : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(BetweenBruteForce, FindsTheSame) {
  const std::uint32_t substeps = GetParam();
  const TestFolder folder;
  write_passing(folder, "scene.json", 6, 3);
  // Its frames are the ends of all pieces.
  const auto fine = scenes::load_scene(write_passing(
      folder, "fine.json", static_cast<int>(6 * substeps), static_cast<int>(3 * substeps)));
  ASSERT_TRUE(fine) << fine.error().message;
  CheckFile file = answer_of(
      folder, 1,
      {"check", "scene.json", "--between", "--substeps", std::to_string(substeps), "--pairs"});
  const std::vector<json> lines = take_steps(file);
  ASSERT_EQ(file.frames.size(), 6u);
  std::size_t line = 0, between = 0, at_ends = 0;
  for (std::uint32_t step = 0; step < 5; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    Meetings meetings;
    std::vector<PosedInstance> from = *tools::scene::pose_instances(*fine, substeps * step, {});
    json ends = brute_force_json(from[0], from[1]);
    for (std::uint32_t piece = 0; piece < substeps; ++piece) {
      const std::uint32_t frame = substeps * step + piece;
      std::vector<PosedInstance> to = *tools::scene::pose_instances(*fine, frame + 1, {});
      add_piece(from, to, frame / (3.0 * substeps), (frame + 1) / (3.0 * substeps), meetings);
      from = std::move(to);
    }
    const std::size_t contacts = meetings.size();
    for (const json& contact : brute_force_json(from[0], from[1])) ends.push_back(contact);
    for (const json& contact : ends) at_ends += meetings.erase({contact[0], contact[1]});
    if (meetings.empty()) continue;
    between += meetings.size();
    ASSERT_LT(line, lines.size());
    const json& found = lines[line++];
    EXPECT_EQ(found["step"], step);
    EXPECT_EQ(found["to"], step + 1);
    EXPECT_EQ(found["contacts"], contacts);
    EXPECT_EQ(found["only_between"], meetings.size());
    ASSERT_EQ(found["pairs"].size(), 1u);
    const json& list = found["pairs"][0]["between"];
    EXPECT_EQ(without_times(list), expected_list(meetings));
    double first = 1e9;
    for (const json& contact : list) {
      const double seconds = meetings.at({contact["triangles"][0], contact["triangles"][1]}).first;
      EXPECT_NEAR(contact["first"].get<double>(), seconds, 1e-12);
      first = std::min(first, seconds);
    }
    EXPECT_NEAR(found["first"].get<double>(), first, 1e-12);
  }
  EXPECT_EQ(line, lines.size());
  EXPECT_EQ(file.totals["totals"]["between"]["contacts"], between);
  EXPECT_GT(between, 100u) << "the test needs contacts between frames";
  EXPECT_GT(at_ends, 10u) << "the test needs contacts in frames";
}

INSTANTIATE_TEST_SUITE_P(Substeps, BetweenBruteForce, ::testing::Values(1, 2));

TEST(CheckBetween, LeavesTheAnswerOfTheFramesAsItIs) {
  const TestFolder folder;
  write_passing(folder, "scene.json", 6, 3);
  const Ended without = run_pelt(folder, {"check", "scene.json", "--jsonl", "-"});
  const Ended with = run_pelt(folder, {"check", "scene.json", "--jsonl", "-", "--between"});
  CheckFile plain = parse_check_file(without.out), between = parse_check_file(with.out);
  EXPECT_FALSE(take_steps(between).empty());
  EXPECT_EQ(between.frames, plain.frames);
  EXPECT_EQ(between.totals["hash"], plain.totals["hash"]);
  EXPECT_EQ(between.totals["touches"], plain.totals["touches"]);
}

TEST(CheckBetween, FailsOnWhatNoFrameShows) {
  const TestFolder folder;
  write_passing(folder, "scene.json", 3, 1);
  const auto exit_code = [&](const Words& options) {
    return run_pelt(folder, joined({"check", "scene.json", "--frames", "0:3:2"}, options))
        .exit_code;
  };
  EXPECT_EQ(exit_code({}), 0);
  EXPECT_EQ(exit_code({"--between"}), 1);
  EXPECT_EQ(exit_code({"--between", "--fail-on", "between"}), 1);
  EXPECT_EQ(exit_code({"--between", "--fail-on", "never"}), 0);
  EXPECT_EQ(exit_code({"--fail-on", "between"}), 2);
}

TEST(CheckBetween, ComparesWithTheTouchesBetweenFramesOfABaseline) {
  const TestFolder folder;
  write_passing(folder, "scene.json", 6, 3);
  const auto check = [&](const Words& options) {
    return run_pelt(folder, joined({"check", "scene.json"}, options));
  };
  check({"--between", "--jsonl", "known.jsonl"});
  check({"--jsonl", "plain.jsonl"});
  const Ended same = check({"--between", "--baseline", "known.jsonl"});
  EXPECT_EQ(same.exit_code, 0) << same.out;
  EXPECT_TRUE(contains(same.out, "as known between frames"));
  const Ended plain = check({"--between", "--baseline", "plain.jsonl"});
  EXPECT_EQ(plain.exit_code, 2);
  EXPECT_TRUE(contains(plain.err, "was written without --between"));
  // The baseline of few frames lacks touches of the others.
  check({"--between", "--frames", "0:3", "--jsonl", "few.jsonl"});
  const Ended more = check({"--between", "--baseline", "few.jsonl", "--jsonl", "-"});
  EXPECT_EQ(more.exit_code, 1);
  const json verdict = parse_check_file(more.out).totals["verdict"]["between"];
  ASSERT_FALSE(verdict["worse"].empty());
  EXPECT_GT(verdict["worse"][0]["contacts"], 0);
  EXPECT_EQ(verdict["gone"], json::array());
}

TEST(CheckBetween, LeavesOutIgnoredPairs) {
  const TestFolder folder;
  write_passing(folder, "scene.json", 6, 3);
  const Ended run =
      run_pelt(folder, 0, {"check", "scene.json", "--between", "--ignore", "one/*,two/*"});
  EXPECT_TRUE(contains(run.out, "between    no pair touches between frames only, in 5 steps"));
}

TEST(CheckBetween, MeasuresHowTheDeviationFalls) {
  const TestFolder folder;
  write_passing(folder, "scene.json", 6, 3);
  const Ended run = run_pelt(folder, {"check", "scene.json", "--between", "--jsonl", "-"});
  const json deviation = parse_check_file(run.out).totals["totals"]["between"]["deviation"];
  ASSERT_EQ(deviation["substeps"].size(), 3u);
  EXPECT_EQ(deviation["distance"], deviation["substeps"][0]["distance"]);
  EXPECT_EQ(deviation["substeps"][2]["substeps"], 4);
  EXPECT_LT(deviation["substeps"][2]["distance"].get<double>(),
            deviation["distance"].get<double>() / 2);
  EXPECT_TRUE(contains(run.err, "straight   vertices deviate at most "));
}

TEST(CheckBetween, TestsNoStepFromOneClipToAnother) {
  const StripFolder folder;
  const Ended run = run_pelt(folder, {"check", "strip.glb", "--clip", "*", "--by", "part",
                                      "--between", "--fps", "4", "--jsonl", "-"});
  const json totals = parse_check_file(run.out).totals;
  EXPECT_EQ(totals["clips"].size(), 2u) << run.err;
  EXPECT_EQ(totals["totals"]["between"]["steps"], totals["totals"]["frames"].get<int>() - 2);
}

TEST(CheckBetween, RefusesWhatItCannotTest) {
  const TestFolder folder;
  write_passing(folder, "scene.json", 6, 3);
  const auto refusal = [&](const Words& options) {
    const Ended run = run_pelt(folder, 2, joined({"check", "scene.json"}, options));
    return run.err;
  };
  const auto refused_with = [&](Words options) {
    options.push_back("--between");
    const std::string message = refusal(options);
    EXPECT_TRUE(contains(message, "cannot be combined with"));
  };
  refused_with({"--first"});
  refused_with({"--max-contacts", "3"});
  refused_with({"--clearance", "0.1"});
  refused_with({"--method", "brute"});
  refused_with({"--budget", "100"});
  EXPECT_TRUE(contains(refusal({"--substeps", "2"}), "requires --between"));
  EXPECT_TRUE(contains(
      run_pelt(folder, {"check", "one.glb", "--clip", "sway", "--self", "no", "--between"}).err,
      "nothing was compared"));
}

}  // namespace
}  // namespace pelt::test
