/// Contacts of characters with themselves.

#include <pelt/version.hpp>

#include "check_self.hpp"
#include "self/neighbours.hpp"
#include "self/self_moving_brute_force.hpp"
#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <map>
#include <tuple>

namespace pelt::test {
namespace {

/// Numbers of surface vertices: equal rest positions have equal numbers.
std::vector<std::uint32_t> self_surface(const asset::Asset& asset) {
  std::map<std::tuple<float, float, float>, std::uint32_t> numbers;
  std::vector<std::uint32_t> surface;
  for (const Vec3& p : asset.rest_positions) {
    const auto count = static_cast<std::uint32_t>(numbers.size());
    surface.push_back(numbers.try_emplace({p.x, p.y, p.z}, count).first->second);
  }
  return surface;
}

/// All pairs of triangles of one instance, by the exact predicate.
json brute_force_self(const scenes::Scene& scene, std::uint32_t instance, std::uint32_t frame) {
  const auto posed = tools::scene::pose_instances(scene, frame, {});
  EXPECT_TRUE(posed);
  const asset::Asset& asset = scene.characters[scene.instances[instance].character].asset;
  const std::vector<std::uint32_t> surface = self_surface(asset);
  const std::vector<Vec3>& at = (*posed)[instance].positions;
  std::vector<detail::SurfaceTriangle> triangles;
  for (const Triangle& t : asset.triangles)
    triangles.push_back(
        {{at[t[0]], at[t[1]], at[t[2]]}, {surface[t[0]], surface[t[1]], surface[t[2]]}});
  json contacts = json::array();
  for (std::uint32_t s = 0; s < triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < triangles.size(); ++t)
      if (detail::surface_triangles_intersect(triangles[s], triangles[t]))
        contacts.push_back({s, t});
  return contacts;
}

void write_curl(const TestFolder& folder) { write_bytes(folder / "curl.glb", build_curl().glb()); }

/// The limb with unskinned triangles on its second joint.
void write_curl_with(const std::vector<float>& triangles, const TestFolder& folder) {
  GltfBuilder builder = build_curl();
  const json attributes = {{"POSITION", builder.add_accessor(triangles, "VEC3")}};
  const json primitive = {{"attributes", attributes}};
  const std::size_t mesh = builder.add("meshes", {{"primitives", {primitive}}});
  const std::size_t node = builder.add("nodes", {{"name", "sheet"}, {"mesh", mesh}});
  builder.document["nodes"][1]["children"].push_back(node);
  write_bytes(folder / "curl.glb", builder.glb());
}

/// The limb with a sheet that crosses it at rest.
void write_pierced_curl(const TestFolder& folder) {
  write_curl_with({-1, 0, 0, 1, 0, 0, 0, 0.05f, 0}, folder);
}

/// The limb with two sheets that cross each other, far from the limb.
void write_curl_and_cross(const TestFolder& folder) {
  write_curl_with({8, 0, 0, 10, 0, 0, 9, 1, 0, 9, 0, -1, 9, 0, 1, 9, 2, 0}, folder);
}

constexpr const char* kTwoCurls = R"({
  "models": {"curl": "curl.glb"},
  "frames": {"count": 12, "fps": 12},
  "instances": [{"model": "curl", "clip": "sway"},
                {"model": "curl", "clip": "sway", "start": 0.3, "translation": [0.1, 0.1, 0]}]
})";

TEST(CheckSelf, EqualsBruteForceInEveryFrame) {
  const TestFolder folder;
  write_curl(folder);
  write_text(folder / "scene.json", kTwoCurls);
  const auto scene = scenes::load_scene(folder / "scene.json");
  ASSERT_TRUE(scene) << scene.error().message;
  const Words all = {"scene.json",     "--self", "--self-rings",       "0",
                     "--self-at-rest", "keep",   "--self-near-joints", "keep"};
  const CheckFile file = check_pairs(folder, 1, all);
  ASSERT_EQ(file.frames.size(), 12u);
  std::size_t with_contact = 0, without = 0;
  for (std::uint32_t frame = 0; frame < 12; ++frame)
    for (const std::uint32_t instance : {0u, 1u}) {
      const json expected = brute_force_self(*scene, instance, frame);
      EXPECT_EQ(triangles_of(file.frames[frame], instance, instance), expected) << frame;
      ++(expected.empty() ? without : with_contact);
    }
  EXPECT_GT(with_contact, 2u);
  EXPECT_GT(without, 1u);
  EXPECT_EQ(file.totals["verdict"]["pairs_compared"], 3);
  EXPECT_EQ(file.totals["hash"], hash_of(file));
}

/// The pairs of triangles of one instance that meet in a step and at neither end, by tests of all.
json brute_force_between(const scenes::Scene& scene, std::uint32_t instance, std::uint32_t frame) {
  const auto from = tools::scene::pose_instances(scene, frame, {});
  const auto to = tools::scene::pose_instances(scene, frame + 1, {});
  EXPECT_TRUE(from && to);
  const asset::Asset& asset = scene.characters[scene.instances[instance].character].asset;
  const std::vector<Vec3>&first = (*from)[instance].positions, &last = (*to)[instance].positions;
  std::vector<detail::MovingTriangle> triangles;
  for (const Triangle& t : asset.triangles)
    triangles.push_back(
        {{first[t[0]], first[t[1]], first[t[2]]}, {last[t[0]], last[t[1]], last[t[2]]}});
  const json at_end = brute_force_self(scene, instance, frame + 1);
  json contacts = json::array();
  for (const MovingContact& c : brute_force_self_moving(
           triangles, surface_corners(asset.triangles, self_surface(asset)), true)) {
    const json pair = {c.contact.triangle_a, c.contact.triangle_b};
    if (!c.at_start && std::find(at_end.begin(), at_end.end(), pair) == at_end.end())
      contacts.push_back(pair);
  }
  return contacts;
}

json between_of(const json& step, std::uint32_t instance) {
  json triangles = json::array();
  for (const json& pair : step["pairs"])
    if (pair["a"] == instance && pair["b"] == instance)
      for (const json& contact : pair["between"]) triangles.push_back(contact["triangles"]);
  return triangles;
}

TEST(CheckSelf, EqualsBruteForceBetweenFrames) {
  const TestFolder folder;
  write_curl(folder);
  write_text(folder / "scene.json", kTwoCurls);
  const auto scene = scenes::load_scene(folder / "scene.json");
  ASSERT_TRUE(scene) << scene.error().message;
  const Words all = {"scene.json", "--self",         "only", "--self-rings",
                     "0",          "--self-at-rest", "keep", "--self-near-joints",
                     "keep",       "--between"};
  CheckFile file = check_pairs(folder, 1, all);
  const std::vector<json> steps = take_steps(file);
  std::size_t contacts = 0, next = 0;
  for (std::uint32_t frame = 0; frame + 1 < 12; ++frame) {
    const json first = brute_force_between(*scene, 0, frame);
    const json second = brute_force_between(*scene, 1, frame);
    contacts += first.size() + second.size();
    if (first.empty() && second.empty()) continue;
    ASSERT_LT(next, steps.size());
    const json& step = steps[next++];
    EXPECT_EQ(step["step"], frame);
    EXPECT_EQ(between_of(step, 0), first);
    EXPECT_EQ(between_of(step, 1), second);
  }
  EXPECT_EQ(next, steps.size());
  EXPECT_GT(contacts, 20u);
}

TEST(CheckSelf, LeavesThePairsOfInstancesAsTheyAre) {
  const TestFolder folder;
  write_curl(folder);
  write_text(folder / "scene.json", kTwoCurls);
  const CheckFile without = check_pairs(folder, 1, {"scene.json"});
  const CheckFile with_self = check_pairs(folder, 1, {"scene.json", "--self"});
  const CheckFile only = check_pairs(folder, 1, {"scene.json", "--self", "only"});
  std::size_t pairs = 0, selves = 0;
  for (std::size_t f = 0; f < 12; ++f) {
    const json both = triangles_of(with_self.frames[f], 0, 1);
    EXPECT_EQ(both, triangles_of(without.frames[f], 0, 1));
    pairs += both.size();
    EXPECT_EQ(triangles_of(only.frames[f], 0, 1), json::array());
    for (const std::uint32_t i : {0u, 1u}) {
      const json self = triangles_of(only.frames[f], i, i);
      EXPECT_EQ(self, triangles_of(with_self.frames[f], i, i));
      EXPECT_EQ(triangles_of(without.frames[f], i, i), json::array());
      selves += self.size();
    }
  }
  EXPECT_GT(pairs, 10u);
  EXPECT_GT(selves, 10u);
  EXPECT_EQ(without.header["options"]["self"], json());
  EXPECT_EQ(with_self.header["options"]["self"]["only"], false);
  EXPECT_EQ(only.header["options"]["self"]["only"], true);
  EXPECT_EQ(only.totals["verdict"]["pairs_compared"], 2);
}

TEST(CheckSelf, IsTheCheckOfASingleCharacter) {
  const TestFolder folder;
  write_curl(folder);
  write_strip(folder, "strip.glb");
  const Ended bent = run_pelt(folder, 1, {"check", "curl.glb", "--clip", "sway"});
  EXPECT_TRUE(contains(bent.out, "self       the instance is tested against itself\n"));
  EXPECT_TRUE(contains(bent.out, "  itself joint 3  in "));
  EXPECT_FALSE(contains(bent.out, "nothing"));
  const Ended kept = run_pelt(folder, {"check", "strip.glb", "--self-near-joints", "keep"});
  EXPECT_EQ(kept.exit_code, 1) << "at rest, without a clip: " << kept.out;
  const Ended straight = run_pelt(folder, 0, {"check", "curl.glb"});
  EXPECT_TRUE(contains(straight.out, "contact    none in 1 frame\n"));
  run_pelt(folder, 0, {"check", "curl.glb", "--by", "part"});
  run_pelt(folder, 2, {"check", "curl.glb", "--self", "no"});
}

TEST(CheckSelf, NotesPartsThatAreNotSkinned) {
  const StripFolder folder;
  const auto summary = [&](const Words& options) {
    return run_pelt(folder, joined({"check", "strip.glb"}, options)).out;
  };
  const std::string note = "note       1 part is not skinned (fan): --no-unskinned leaves it out\n";
  EXPECT_TRUE(contains(summary({}), note));
  EXPECT_FALSE(contains(summary({"--no-unskinned"}), "not skinned"));
  EXPECT_FALSE(contains(summary({"strip.glb"}), "not skinned"));
}

TEST(CheckSelf, IsChosenByTheSceneToo) {
  const TestFolder folder;
  write_curl(folder);
  const auto scene_with = [](const std::string& members) {
    return "{" + members + std::string(kTwoCurls).substr(1);
  };
  write_text(folder / "scene.json",
             scene_with(R"("self": "only", "self_rings": 2, "self_at_rest": "keep",
                           "self_always": 0.5, "self_near_joints": "drop",)"));
  const json chosen = {
      {"only", true}, {"rings", 2}, {"at_rest", "keep"}, {"always", 0.5}, {"near_joints", "drop"}};
  const Words scene = {"check", "scene.json", "--fail-on", "never", "--jsonl", "-"};
  const Ended run = run_pelt(folder, scene);
  EXPECT_EQ(parse_check_file(run.out).header["options"]["self"], chosen) << run.err;
  const Ended replaced =
      run_pelt(folder, joined(scene, {"--self", "yes", "--self-always", "keep"}));
  const json options = parse_check_file(replaced.out).header["options"]["self"];
  EXPECT_EQ(options["only"], false);
  EXPECT_EQ(options["always"], "keep");
  EXPECT_EQ(options["rings"], 2);
  for (const char* wrong : {"\"self\": 1,", "\"self_rings\": 65,", "\"self_at_rest\": true,",
                            "\"self_always\": 0,", "\"self_near_joints\": \"no\","}) {
    write_text(folder / "scene.json", scene_with(wrong));
    const Ended refused = run_pelt(folder, 2, scene);
    EXPECT_TRUE(contains(refused.err, "scene.json: self"));
  }
}

/// The number of contacts, and how many each filter has left out.
std::map<std::string, std::uint64_t> counts_of(const CheckFile& file) {
  std::map<std::string, std::uint64_t> counts = file.totals["totals"]["left_out"];
  counts["contacts"] = file.totals["totals"]["contacts"];
  for (const auto& [filter, count] : file.totals["totals"]["left_out"].items()) {
    std::uint64_t sum = 0;
    for (const json& line : file.frames) sum += line["left_out"][filter].get<std::uint64_t>();
    EXPECT_EQ(sum, count) << filter;
  }
  return counts;
}

TEST(CheckSelf, FiltersTellWhatTheyLeaveOut) {
  const TestFolder folder;
  write_pierced_curl(folder);
  const Words curl = {"curl.glb", "--clip", "sway", "--frames", "1:30:4"};
  const Words full = {"--self-rings", "0", "--self-at-rest", "keep"};
  const Words keep = joined(full, {"--self-near-joints", "keep"});
  const auto counts = [&](const Words& options, int exit_code) {
    return counts_of(check_pairs(folder, exit_code, joined(curl, options)));
  };
  auto all = counts(keep, 1);
  ASSERT_GT(all["contacts"], 8u);
  auto at_rest = counts({"--self-rings", "0", "--self-near-joints", "keep"}, 1);
  EXPECT_GT(at_rest["at_rest"], 0u);
  EXPECT_GT(at_rest["contacts"], 0u);
  EXPECT_EQ(at_rest["at_rest"] + at_rest["contacts"], all["contacts"]);
  auto always = counts(joined(keep, {"--self-always", "1"}), 1);
  EXPECT_GT(always["always"], 0u);
  EXPECT_EQ(always["always"] % 8, 0u);
  EXPECT_EQ(always["always"] + always["contacts"], all["contacts"]);
  // The sheet touches its own joint only; the limb touches itself farther away.
  auto near = counts(joined(full, {"--self-near-joints", "drop"}), 1);
  EXPECT_GT(near["near_joints"], 0u);
  EXPECT_GT(near["contacts"], 0u);
  EXPECT_EQ(near["near_joints"] + near["contacts"], all["contacts"]);
  const Ended words = run_pelt(folder, joined({"check"}, curl));
  EXPECT_TRUE(contains(words.out, " by --self-near-joints"));
}

TEST(CheckSelf, SuggestsToDropContactsOfNearlyEveryFrame) {
  const TestFolder folder;
  write_curl_and_cross(folder);
  const Words curl = {"curl.glb",           "--clip", "sway", "--self-at-rest", "keep",
                      "--self-near-joints", "keep"};
  const Words start = joined(curl, {"--frames", "0:14"});
  auto all = counts_of(check_pairs(folder, 1, start));
  auto dropping = counts_of(
      check_pairs(folder, 0, joined(start, {"--self-always", "0.95", "--fail-on", "never"})));
  EXPECT_EQ(all["contacts"] - dropping["contacts"], dropping["always"]);
  EXPECT_LT(dropping["always"], all["contacts"]);
  ASSERT_GE(3 * dropping["always"], all["contacts"]);
  const auto summary = [&](const Words& words, const Words& options) {
    return run_pelt(folder, joined({"check"}, joined(words, options))).out;
  };
  const std::string note = "note       " + std::to_string(dropping["always"]) + " of " +
                           std::to_string(all["contacts"]) +
                           " self-contacts are in nearly every frame: --self-always 0.95 drops "
                           "them\n";
  EXPECT_TRUE(contains(summary(start, {}), note));
  EXPECT_TRUE(contains(summary(curl, {"--frames", "0:8"}), "nearly every frame"));
  for (const char* frames : {"0:7", "0:30"})  // too few frames; and most contacts change
    EXPECT_FALSE(contains(summary(curl, {"--frames", frames}), "nearly every frame"));
  for (const Words& options : {Words{"--self-always", "keep"}, {"--max-contacts", "99"}})
    EXPECT_FALSE(contains(summary(start, options), "nearly every frame")) << options[0];
}

TEST(CheckSelf, RingsLeaveOutNeighbours) {
  const TestFolder folder;
  write_curl(folder);
  const Words curl = {"curl.glb", "--clip", "sway", "--self-near-joints", "keep"};
  std::uint64_t all = 0, last = 0;
  for (const char* rings : {"0", "1", "2", "5"}) {
    auto counts = counts_of(check_pairs(folder, 1, joined(curl, {"--self-rings", rings})));
    if (all == 0) last = all = counts["contacts"];
    EXPECT_EQ(counts["rings"] + counts["contacts"], all) << rings;
    EXPECT_LE(counts["contacts"], last) << rings;
    last = counts["contacts"];
  }
  EXPECT_LT(last, all);
}

TEST(CheckSelf, WorksWithNamesBaselinesAndLimits) {
  const TestFolder folder;
  write_curl(folder);
  const Words curl = {"curl.glb", "--clip", "sway"};
  const CheckFile all = check_pairs(folder, 1, curl);
  const std::uint64_t contacts = all.totals["totals"]["contacts"];
  const CheckFile ignoring =
      check_pairs(folder, 0, joined(curl, {"--ignore", "joint 0,joint*", "--fail-on", "never"}));
  const std::uint64_t ignored = ignoring.totals["totals"]["ignored"];
  EXPECT_GT(ignored, 0u);
  EXPECT_EQ(ignored + ignoring.totals["totals"]["contacts"].get<std::uint64_t>(), contacts);
  check_pairs(folder, 0, joined(curl, {"--ignore", "joint*,joint*"}));

  run_pelt(folder, joined({"check", "--jsonl", "known.jsonl"}, curl));
  check_pairs(folder, 0, joined(curl, {"--baseline", "known.jsonl"}));
  const Ended grown =
      run_pelt(folder, joined({"check", "--baseline", "known.jsonl", "--self-rings", "0"}, curl));
  EXPECT_TRUE(contains(grown.out, "note       self was {"));
  const Ended other =
      run_pelt(folder, 2, joined({"check", "--baseline", "known.jsonl", "--self", "no"}, curl));
  EXPECT_TRUE(contains(other.err, "was written with --self"));

  for (const Words& limit : {Words{"--first"}, Words{"--max-contacts", "1"}}) {
    const CheckFile limited = check_pairs(folder, 1, joined(curl, limit));
    ASSERT_EQ(limited.frames.size(), all.frames.size());
    for (std::size_t f = 0; f < all.frames.size(); ++f)
      EXPECT_EQ(limited.frames[f]["contacts"], all.frames[f]["contacts"] > 0 ? 1 : 0);
  }
}

TEST(CheckSelf, DescribesContacts) {
  const TestFolder folder;
  write_curl(folder);
  const CheckFile file =
      check_pairs(folder, 1, {"curl.glb", "--clip", "sway", "--contacts", "--glb", "worst.glb"});
  std::size_t traces = 0;
  for (const json& line : file.frames)
    for (const json& pair : line["pairs"]) {
      EXPECT_EQ(pair["traces"].size(), pair["contacts"]);
      EXPECT_FALSE(pair["patches"].empty());
      for (std::size_t i = 0; i < pair["traces"].size(); ++i)
        EXPECT_EQ(pair["traces"][i]["triangles"], pair["triangles"][i]);
      traces += pair["traces"].size();
    }
  EXPECT_GT(traces, 10u);
  EXPECT_GT(std::filesystem::file_size(folder / "worst.glb"), 1000u);
}

TEST(CheckSelf, RefusesWhatItCannotDo) {
  const StripFolder folder;
  const auto refused = [&](const Words& options, const std::string& words) {
    const Ended run = run_pelt(folder, 2, joined({"check", "strip.glb"}, options));
    EXPECT_TRUE(contains(run.err, words));
  };
  refused({"--self", "--method", "brute"}, "--self: cannot be combined with --method");
  refused({"--self", "--clearance", "0.1"}, "--self: cannot be combined with --clearance");
  refused({"--self=many"}, "--self: unknown value \"many\"");
  for (const char* rings : {"65", "-1", "few"})
    refused({"--self-rings", rings},
            std::string("--self-rings: \"") + rings +
                "\" is not allowed: give a whole number from 0 to 64: see pelt check --help\n");
  refused({"--self-at-rest", "on"}, "--self-at-rest: unknown value \"on\"");
  refused({"--self-always", "2"}, "--self-always: unknown value \"2\"");
  refused({"--self-near-joints", "no"}, "--self-near-joints: unknown value \"no\"");
}

TEST(CheckSelf, TakesNoInputAsItsValue) {
  const StripFolder folder;
  const Words keep = {"--self-near-joints", "keep"};
  run_pelt(folder, 1, joined({"check", "--self", "strip.glb"}, keep));
  run_pelt(folder, 1, joined({"check", "--self", "only", "strip.glb"}, keep));
}

}  // namespace
}  // namespace pelt::test
