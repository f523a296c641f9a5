/// Contacts of the parts of one character, with the filters of contacts with itself.

#include "check_self.hpp"
#include "tools/answer.hpp"
#include "tools/test_scenes.hpp"

#include <map>
#include <set>
#include <utility>

namespace pelt::test {
namespace {

TEST(CheckSelfOfParts, IsBesideTheirPairs) {
  const StripFolder folder;
  const Words strip = {"strip.glb", "--clip", "bend", "--by", "part", "--frames", "0:30:4"};
  const CheckFile pairs = check_pairs(folder, 1, strip);
  const CheckFile both =
      check_pairs(folder, 1, joined(strip, joined({"--self", "--self-rings", "0"}, kKeepAll)));
  EXPECT_EQ(pairs.header["options"]["self"], json());
  EXPECT_EQ(both.totals["verdict"]["pairs_compared"], 3);
  for (std::size_t f = 0; f < 8; ++f)
    EXPECT_EQ(triangles_of(both.frames[f], 0, 1), triangles_of(pairs.frames[f], 0, 1));
}

using TrianglePair = std::pair<std::uint32_t, std::uint32_t>;

/// All contacts of one frame within an instance, by the numbers of the triangles.
std::set<TrianglePair> contacts_of(const json& line) {
  std::set<TrianglePair> contacts;
  for (const json& pair : line["pairs"])
    for (const json& t : pair["triangles"])
      contacts.emplace(t[0].get<std::uint32_t>(), t[1].get<std::uint32_t>());
  return contacts;
}

/// The limb with two sheets on its second and third joints: one crosses the limb at rest, the other
/// only when it bends.
void write_dressed_curl(const TestFolder& folder) {
  GltfBuilder builder = build_curl();
  const auto add_sheet = [&](const char* name, std::size_t parent, float height) {
    const std::vector<float> corners = {-1, height, 0, 1, height, 0, 0, height + 0.05f, 0.02f};
    const json attributes = {{"POSITION", builder.add_accessor(corners, "VEC3")}};
    const json primitive = {{"attributes", attributes}};
    const std::size_t mesh = builder.add("meshes", {{"name", name}, {"primitives", {primitive}}});
    const std::size_t node = builder.add("nodes", {{"name", name}, {"mesh", mesh}});
    builder.document["nodes"][parent]["children"].push_back(node);
  };
  add_sheet("sheet", 1, 0);
  add_sheet("other", 2, 0.12f);
  write_bytes(folder / "dressed.glb", builder.glb());
}

/// The contacts of all frames that the filters drop, straight from the definitions. Triangles that
/// share a corner are never in two parts of this character.
struct DroppedPairs {
  std::set<TrianglePair> at_rest, always;

  DroppedPairs(const json& rest_line, const std::vector<json>& lines, double share)
      : at_rest(contacts_of(rest_line)) {
    std::map<TrianglePair, std::size_t> frames;
    for (const json& line : lines)
      for (const TrianglePair& pair : contacts_of(line)) ++frames[pair];
    for (const auto& [pair, count] : frames)
      if (static_cast<double>(count) >= share * static_cast<double>(lines.size()))
        always.insert(pair);
  }
};

TEST(CheckSelfOfParts, FiltersServeTwoPartsOfOneCharacter) {
  const TestFolder folder;
  write_dressed_curl(folder);
  const Words dressed = {"dressed.glb", "--by", "part", "--self", "--self-rings", "0"};
  const Words moving = joined(dressed, {"--clip", "sway", "--frames", "0:30:3"});
  const CheckFile all = check_pairs(folder, 1, joined(moving, kKeepAll));
  const CheckFile rest = check_pairs(folder, 1, joined(dressed, kKeepAll));
  const DroppedPairs dropped(rest.frames[0], all.frames, 0.9);
  const auto expect_without = [&](const Words& options, const char* filter,
                                  const std::set<TrianglePair>& out) {
    const CheckFile file =
        check_pairs(folder, 0, joined(moving, joined({"--fail-on", "never"}, options)));
    std::size_t kept = 0, left_out = 0;
    for (std::size_t f = 0; f < all.frames.size(); ++f) {
      std::set<TrianglePair> expected;
      for (const TrianglePair& pair : contacts_of(all.frames[f]))
        if (!out.contains(pair)) expected.insert(pair);
      EXPECT_EQ(contacts_of(file.frames[f]), expected) << filter << f;
      const std::size_t lacking = contacts_of(all.frames[f]).size() - expected.size();
      EXPECT_EQ(file.frames[f]["left_out"][filter], lacking) << filter << f;
      kept += expected.size();
      left_out += lacking;
    }
    EXPECT_GT(kept, 5u) << filter;
    EXPECT_GT(left_out, 5u) << filter;
    EXPECT_EQ(file.totals["totals"]["left_out"][filter], left_out);
  };
  expect_without({"--self-near-joints", "keep"}, "at_rest", dropped.at_rest);
  expect_without(joined(kKeepAll, {"--self-always", "0.9"}), "always", dropped.always);

  const CheckFile near =
      check_pairs(folder, 0, joined(moving, {"--self-at-rest", "keep", "--fail-on", "never"}));
  const CheckFile whole =
      check_pairs(folder, 0,
                  {"dressed.glb", "--clip", "sway", "--frames", "0:30:3", "--self-rings", "0",
                   "--self-at-rest", "keep", "--fail-on", "never"});
  std::size_t contacts = 0;
  for (std::size_t f = 0; f < near.frames.size(); ++f) {
    EXPECT_EQ(contacts_of(near.frames[f]), contacts_of(whole.frames[f])) << f;
    contacts += contacts_of(near.frames[f]).size();
  }
  EXPECT_GT(contacts, 5u);
  EXPECT_GT(near.totals["totals"]["left_out"]["near_joints"], 5u);
  EXPECT_EQ(near.totals["totals"]["left_out"], whole.totals["totals"]["left_out"]);
}

TEST(CheckSelfOfParts, LimitsWhatTheFiltersKeep) {
  const TestFolder folder;
  write_dressed_curl(folder);
  const Words dressed = {
      "dressed.glb",        "--clip", "sway", "--by", "part", "--self", "--self-rings", "0",
      "--self-near-joints", "keep"};
  const CheckFile all = check_pairs(folder, 1, dressed);
  const CheckFile first = check_pairs(folder, 1, joined(dressed, {"--first"}));
  for (std::size_t f = 0; f < all.frames.size(); ++f) {
    ASSERT_EQ(first.frames[f]["pairs"].size(), all.frames[f]["pairs"].size());
    for (const json& pair : first.frames[f]["pairs"]) EXPECT_EQ(pair["contacts"], 1);
  }
}

}  // namespace
}  // namespace pelt::test
