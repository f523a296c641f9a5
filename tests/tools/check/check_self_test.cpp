/// Contacts of characters with themselves.

#include <pelt/version.hpp>

#include "check_self.hpp"
#include "self/neighbour_pair.hpp"
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
  const CommandWords all = {"scene.json",     "--self", "--self-rings",       "0",
                            "--self-at-rest", "keep",   "--self-near-joints", "keep"};
  const CheckFile file = check_self(folder, all, 1);
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
  const CommandWords all = {"scene.json", "--self",         "only", "--self-rings",
                            "0",          "--self-at-rest", "keep", "--self-near-joints",
                            "keep",       "--between"};
  CheckFile file = check_self(folder, all, 1);
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
  const CheckFile without = check_self(folder, {"scene.json"}, 1);
  const CheckFile with_self = check_self(folder, {"scene.json", "--self"}, 1);
  const CheckFile only = check_self(folder, {"scene.json", "--self", "only"}, 1);
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
  const Ended bent = run_pelt(folder, {"check", "curl.glb", "--clip", "sway"});
  EXPECT_EQ(bent.exit_code, 1) << bent.err;
  EXPECT_NE(bent.out.find("self       the instance is tested against itself\n"), std::string::npos)
      << bent.out;
  EXPECT_NE(bent.out.find("  itself joint 3  in "), std::string::npos) << bent.out;
  EXPECT_EQ(bent.out.find("nothing"), std::string::npos) << bent.out;
  const Ended kept = run_pelt(folder, {"check", "strip.glb", "--self-near-joints", "keep"});
  EXPECT_EQ(kept.exit_code, 1) << "at rest, without a clip: " << kept.out;
  const Ended straight = run_pelt(folder, {"check", "curl.glb"});
  EXPECT_EQ(straight.exit_code, 0) << straight.err;
  EXPECT_NE(straight.out.find("contact    none in 1 frame\n"), std::string::npos) << straight.out;
  EXPECT_EQ(run_pelt(folder, {"check", "curl.glb", "--by", "part"}).exit_code, 0);
  EXPECT_EQ(run_pelt(folder, {"check", "curl.glb", "--self", "no"}).exit_code, 2);
}

TEST(CheckSelf, NotesPartsThatAreNotSkinned) {
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const auto summary = [&](const CommandWords& options) {
    return run_pelt(folder, self_words({"check", "strip.glb"}, options)).out;
  };
  const std::string note = "note       1 part is not skinned (fan): --no-unskinned leaves it out\n";
  EXPECT_NE(summary({}).find(note), std::string::npos) << summary({});
  EXPECT_EQ(summary({"--no-unskinned"}).find("not skinned"), std::string::npos);
  EXPECT_EQ(summary({"strip.glb"}).find("not skinned"), std::string::npos);
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
  const CommandWords scene = {"check", "scene.json", "--fail-on", "never", "--jsonl", "-"};
  const Ended run = run_pelt(folder, scene);
  EXPECT_EQ(parse_check_file(run.out).header["options"]["self"], chosen) << run.err;
  const Ended replaced =
      run_pelt(folder, self_words(scene, {"--self", "yes", "--self-always", "keep"}));
  const json options = parse_check_file(replaced.out).header["options"]["self"];
  EXPECT_EQ(options["only"], false);
  EXPECT_EQ(options["always"], "keep");
  EXPECT_EQ(options["rings"], 2);
  for (const char* wrong : {"\"self\": 1,", "\"self_rings\": 65,", "\"self_at_rest\": true,",
                            "\"self_always\": 0,", "\"self_near_joints\": \"no\","}) {
    write_text(folder / "scene.json", scene_with(wrong));
    const Ended refused = run_pelt(folder, scene);
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_NE(refused.err.find("scene.json: self"), std::string::npos) << refused.err;
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
  const CommandWords curl = {"curl.glb", "--clip", "sway", "--frames", "1:30:4"};
  const CommandWords full = {"--self-rings", "0", "--self-at-rest", "keep"};
  const CommandWords keep = self_words(full, {"--self-near-joints", "keep"});
  const auto counts = [&](const CommandWords& options, int exit_code) {
    return counts_of(check_self(folder, self_words(curl, options), exit_code));
  };
  auto all = counts(keep, 1);
  ASSERT_GT(all["contacts"], 8u);
  auto at_rest = counts({"--self-rings", "0", "--self-near-joints", "keep"}, 1);
  EXPECT_GT(at_rest["at_rest"], 0u);
  EXPECT_GT(at_rest["contacts"], 0u);
  EXPECT_EQ(at_rest["at_rest"] + at_rest["contacts"], all["contacts"]);
  auto always = counts(self_words(keep, {"--self-always", "1"}), 1);
  EXPECT_GT(always["always"], 0u);
  EXPECT_EQ(always["always"] % 8, 0u);
  EXPECT_EQ(always["always"] + always["contacts"], all["contacts"]);
  // The sheet touches its own joint only; the limb touches itself farther away.
  auto near = counts(self_words(full, {"--self-near-joints", "drop"}), 1);
  EXPECT_GT(near["near_joints"], 0u);
  EXPECT_GT(near["contacts"], 0u);
  EXPECT_EQ(near["near_joints"] + near["contacts"], all["contacts"]);
  const Ended words = run_pelt(folder, self_words({"check"}, curl));
  EXPECT_NE(words.out.find(" by --self-near-joints"), std::string::npos) << words.out;
}

TEST(CheckSelf, SuggestsToDropContactsOfNearlyEveryFrame) {
  const TestFolder folder;
  write_curl_and_cross(folder);
  const CommandWords curl = {"curl.glb",           "--clip", "sway", "--self-at-rest", "keep",
                             "--self-near-joints", "keep"};
  const CommandWords start = self_words(curl, {"--frames", "0:14"});
  auto all = counts_of(check_self(folder, start, 1));
  auto dropping = counts_of(
      check_self(folder, self_words(start, {"--self-always", "0.95", "--fail-on", "never"}), 0));
  EXPECT_EQ(all["contacts"] - dropping["contacts"], dropping["always"]);
  EXPECT_LT(dropping["always"], all["contacts"]);
  ASSERT_GE(3 * dropping["always"], all["contacts"]);
  const auto summary = [&](const CommandWords& words, const CommandWords& options) {
    return run_pelt(folder, self_words({"check"}, self_words(words, options))).out;
  };
  const std::string note = "note       " + std::to_string(dropping["always"]) + " of " +
                           std::to_string(all["contacts"]) +
                           " self-contacts are in nearly every frame: --self-always 0.95 drops "
                           "them\n";
  EXPECT_NE(summary(start, {}).find(note), std::string::npos) << note << summary(start, {});
  EXPECT_NE(summary(curl, {"--frames", "0:8"}).find("nearly every frame"), std::string::npos);
  for (const char* frames : {"0:7", "0:30"})  // too few frames; and most contacts change
    EXPECT_EQ(summary(curl, {"--frames", frames}).find("nearly every frame"), std::string::npos);
  for (const CommandWords& options :
       {CommandWords{"--self-always", "keep"}, {"--max-contacts", "99"}})
    EXPECT_EQ(summary(start, options).find("nearly every frame"), std::string::npos) << options[0];
}

TEST(CheckSelf, RingsLeaveOutNeighbours) {
  const TestFolder folder;
  write_curl(folder);
  const CommandWords curl = {"curl.glb", "--clip", "sway", "--self-near-joints", "keep"};
  std::uint64_t all = 0, last = 0;
  for (const char* rings : {"0", "1", "2", "5"}) {
    auto counts = counts_of(check_self(folder, self_words(curl, {"--self-rings", rings}), 1));
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
  const CommandWords curl = {"curl.glb", "--clip", "sway"};
  const CheckFile all = check_self(folder, curl, 1);
  const std::uint64_t contacts = all.totals["totals"]["contacts"];
  const CheckFile ignoring =
      check_self(folder, self_words(curl, {"--ignore", "joint 0,joint*", "--fail-on", "never"}), 0);
  const std::uint64_t ignored = ignoring.totals["totals"]["ignored"];
  EXPECT_GT(ignored, 0u);
  EXPECT_EQ(ignored + ignoring.totals["totals"]["contacts"].get<std::uint64_t>(), contacts);
  check_self(folder, self_words(curl, {"--ignore", "joint*,joint*"}), 0);

  run_pelt(folder, self_words({"check", "--jsonl", "known.jsonl"}, curl));
  check_self(folder, self_words(curl, {"--baseline", "known.jsonl"}), 0);
  const Ended grown = run_pelt(
      folder, self_words({"check", "--baseline", "known.jsonl", "--self-rings", "0"}, curl));
  EXPECT_NE(grown.out.find("note       self was {"), std::string::npos) << grown.out;
  const Ended other =
      run_pelt(folder, self_words({"check", "--baseline", "known.jsonl", "--self", "no"}, curl));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("was written with --self"), std::string::npos) << other.err;

  for (const CommandWords& limit : {CommandWords{"--first"}, CommandWords{"--max-contacts", "1"}}) {
    const CheckFile limited = check_self(folder, self_words(curl, limit), 1);
    ASSERT_EQ(limited.frames.size(), all.frames.size());
    for (std::size_t f = 0; f < all.frames.size(); ++f)
      EXPECT_EQ(limited.frames[f]["contacts"], all.frames[f]["contacts"] > 0 ? 1 : 0);
  }
}

TEST(CheckSelf, DescribesContacts) {
  const TestFolder folder;
  write_curl(folder);
  const CheckFile file =
      check_self(folder, {"curl.glb", "--clip", "sway", "--contacts", "--glb", "worst.glb"}, 1);
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
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const auto refused = [&](const CommandWords& options, const std::string& words) {
    const Ended run = run_pelt(folder, self_words({"check", "strip.glb"}, options));
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
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
  const TestFolder folder;
  write_strip(folder, "strip.glb");
  const CommandWords keep = {"--self-near-joints", "keep"};
  EXPECT_EQ(run_pelt(folder, self_words({"check", "--self", "strip.glb"}, keep)).exit_code, 1);
  EXPECT_EQ(run_pelt(folder, self_words({"check", "--self", "only", "strip.glb"}, keep)).exit_code,
            1);
}

}  // namespace
}  // namespace pelt::test
