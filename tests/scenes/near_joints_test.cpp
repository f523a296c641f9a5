#include "scenes/triangle_labels.hpp"

#include <pelt/pelt.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pelt::scenes {
namespace {

using Pairs = std::set<std::pair<int, int>>;

/// A character whose triangle t follows joint t and lies alone.
asset::Asset asset_with(const std::vector<std::uint32_t>& parents,
                        const std::vector<std::uint32_t>& joint_nodes) {
  asset::Asset asset;
  for (const std::uint32_t parent : parents) {
    asset.nodes.emplace_back();
    asset.nodes.back().parent = parent;
  }
  for (const std::uint32_t node : joint_nodes) {
    asset.joints.emplace_back();
    asset.joints.back().node = node;
    const auto first = static_cast<std::uint32_t>(asset.rest_positions.size());
    for (std::uint32_t k = 0; k < 3; ++k)
      asset.rest_positions.push_back({static_cast<float>(first + k), 0, 0});
    asset.triangles.push_back({first, first + 1, first + 2});
  }
  return asset;
}

/// Adds a clip that turns these nodes.
void add_clip(asset::Asset& asset, const std::vector<std::uint32_t>& nodes) {
  asset.clips.emplace_back();
  for (const std::uint32_t node : nodes)
    asset.clips.back().channels.push_back(
        {node, asset::Path::rotation, {}, {0, 1}, {0, 0, 0, 1, 0, 0.6F, 0, 0.8F}});
}

/// Gives two triangles a corner in common.
void join(asset::Asset& asset, std::uint32_t s, std::uint32_t t) {
  asset.rest_positions[asset.triangles[t][1]] = asset.rest_positions[asset.triangles[s][2]];
}

std::vector<std::uint16_t> own_joints(const asset::Asset& asset) {
  std::vector<std::uint16_t> joints(asset.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) joints[j] = static_cast<std::uint16_t>(j);
  return joints;
}

/// Unordered pairs of bodies that are near in their zone only.
Pairs pairs_in_zones(const asset::Asset& asset) {
  Pairs pairs;
  for (const IndexPair& pair : near_joints(asset, own_joints(asset), {}).joint_pairs_in_zones)
    pairs.insert(std::minmax(pair.first, pair.second));
  return pairs;
}

/// Unordered pairs of bodies that are near everywhere. The triangles follow `main_joints`, or each
/// its own joint.
Pairs near_pairs(const asset::Asset& asset, std::vector<std::uint16_t> main_joints = {},
                 const std::vector<Contact>& at_rest = {}) {
  if (main_joints.empty()) main_joints = own_joints(asset);
  Pairs pairs;
  for (const IndexPair& pair : near_joints(asset, main_joints, at_rest).joint_pairs)
    pairs.insert(std::minmax(pair.first, pair.second));
  return pairs;
}

constexpr std::uint32_t kNone = asset::kNoParent;

TEST(NearJoints, AreAJointWithItselfAndTheNextJointAbove) {
  // A chain of the nodes 0 to 3, of which node 2 is no joint, and node 4 beside node 1.
  const asset::Asset asset = asset_with({kNone, 0, 1, 2, 0}, {0, 1, 3, 4});
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 1}, {1, 2}, {0, 3}}));
}

TEST(NearJoints, CountJointsOfOtherSkinsAtTheSameNodesAsOne) {
  const asset::Asset asset = asset_with({kNone, 0}, {0, 1, 0, 1});
  EXPECT_EQ(near_joints(asset, own_joints(asset), {}).bodies,
            (std::vector<std::uint16_t>{0, 1, 0, 1}));
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {0, 1}}));
}

TEST(NearJoints, SkipJointsWithoutTriangles) {
  const asset::Asset asset = asset_with({kNone, 0, 1, 2}, {0, 1, 2, 3});
  const Pairs pairs = near_pairs(asset, {0, 0, 3, 3});
  EXPECT_TRUE(pairs.contains({0, 3}));
  EXPECT_FALSE(near_pairs(asset).contains({0, 3}));
}

TEST(NearJoints, CountJointsThatNoClipMovesAgainstEachOtherAsOne) {
  // A helmet, node 3, on the head, node 2, above the chest and the hips.
  asset::Asset asset = asset_with({kNone, 0, 1, 2}, {0, 1, 2, 3});
  EXPECT_FALSE(near_pairs(asset).contains({1, 3}));
  add_clip(asset, {1, 2});
  EXPECT_EQ(near_joints(asset, own_joints(asset), {}).bodies,
            (std::vector<std::uint16_t>{0, 1, 2, 2}));
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}}));
  add_clip(asset, {3});
  EXPECT_EQ(near_joints(asset, own_joints(asset), {}).bodies, own_joints(asset));
}

TEST(NearJoints, IncludeJointsAboveWhoseTrianglesShareACorner) {
  // The chest with two chains of a collarbone and an arm.
  asset::Asset asset = asset_with({kNone, 0, 1, 0, 3}, {0, 1, 2, 3, 4});
  const Pairs apart = near_pairs(asset);
  EXPECT_EQ(apart, (Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {0, 1}, {1, 2}, {0, 3}, {3, 4}}));
  EXPECT_EQ(pairs_in_zones(asset), Pairs{});
  join(asset, 0, 2);
  EXPECT_EQ(near_pairs(asset), apart);
  EXPECT_EQ(pairs_in_zones(asset), (Pairs{{0, 2}}));
  join(asset, 3, 1);  // the collarbones: neither is above the other
  EXPECT_EQ(near_pairs(asset), apart);
  EXPECT_EQ(pairs_in_zones(asset), (Pairs{{0, 2}}));
}

TEST(NearJoints, AreNearOnlyInTheZoneOfTheirJointIfTheyShareACorner) {
  asset::Asset asset = asset_with({kNone, 0, 1}, {0, 1, 2});
  join(asset, 0, 1);
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {2, 2}, {1, 2}}));
  EXPECT_EQ(pairs_in_zones(asset), (Pairs{{0, 1}}));
  const std::vector<TriangleZone> zones = near_joints(asset, own_joints(asset), {}).zones;
  for (const auto& [triangle, zone] : zones) EXPECT_EQ(zone, 1);
  EXPECT_EQ(zones.size(), 2u);
  EXPECT_TRUE(near_pairs(asset, {}, {{0, 1}}).contains({0, 1})) << "everywhere if they touch";
}

TEST(NearJoints, IncludeJointsWhoseTrianglesTouchAtRest) {
  const asset::Asset asset = asset_with({kNone, 0, 0}, {0, 1, 2});
  EXPECT_FALSE(near_pairs(asset).contains({1, 2}));
  EXPECT_TRUE(near_pairs(asset, {}, {{2, 1}}).contains({1, 2}));
}

TEST(NearJoints, OfNoJointsAreNone) {
  EXPECT_TRUE(near_joints(asset_with({kNone}, {}), {}, {}).joint_pairs.empty());
}

// The near joints of a real character leave out the creases of its clips, but not an upper arm
// that is turned into the ribs.

class Human : public testing::Test {
 protected:
  void SetUp() override {
    const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / "human.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    asset_ = *asset::load_gltf(path);
    labels_ = label_triangles(asset_)->joint;
    palette_.resize(asset_.joints.size());
    model_.emplace(*build_model(asset_.mesh()));
    const NearJoints near = near_joints(asset_, labels_, {});
    SelfFilterOptions options = {.rings = 5, .joint_bodies = near.bodies};
    without_near_.emplace(*build_self_filter(*model_, options));
    options.joint_pairs = near.joint_pairs;
    options.joint_pairs_in_zones = near.joint_pairs_in_zones;
    options.zones = near.zones;
    filter_.emplace(*build_self_filter(*model_, options));
  }

  void sample(const std::string& clip, float seconds) {
    for (const asset::Clip& c : asset_.clips)
      if (c.name == clip) asset::sample_palette(asset_, &c, seconds, Matrix4{}, samples_, palette_);
  }

  /// Turns a node and all below it about the axis z through the node.
  void turn(const std::string& name, double degrees) {
    const double angle = degrees / 180 * 3.141592653589793;
    const double c = std::cos(angle), s = std::sin(angle);
    std::array<double, 3> pivot{};
    for (std::size_t j = 0; j < palette_.size(); ++j)
      if (asset_.nodes[asset_.joints[j].node].name == name) pivot = origin_of(j);
    for (std::size_t j = 0; j < palette_.size(); ++j) {
      if (!is_at_or_below(asset_.joints[j].node, name)) continue;
      for (std::size_t column = 0; column < 4; ++column) {
        float* m = &palette_[j].m[4 * column];
        const double shift = column == 3 ? 1 : 0;
        const double x = m[0] - shift * pivot[0], y = m[1] - shift * pivot[1];
        m[0] = static_cast<float>(c * x - s * y + shift * pivot[0]);
        m[1] = static_cast<float>(s * x + c * y + shift * pivot[1]);
      }
    }
  }

  /// Returns the number of contacts of the pose between joints whose names contain these words.
  std::size_t contacts(const SelfFilter& filter, const char* first, const char* second) {
    Pose pose(*model_);
    EXPECT_TRUE(pose.set_palette(palette_));
    std::vector<Contact> found;
    self_collide(pose, filter, scratch_, found);
    std::size_t count = 0;
    for (const Contact& contact : found) {
      const std::string &a = name_of(contact.triangle_a), &b = name_of(contact.triangle_b);
      const auto has = [](const std::string& name, const char* word) {
        return name.find(word) != std::string::npos;
      };
      count += (has(a, first) && has(b, second)) || (has(b, first) && has(a, second));
    }
    return count;
  }

  asset::Asset asset_;
  std::vector<std::uint16_t> labels_;
  std::optional<SkinnedModel> model_;
  std::optional<SelfFilter> filter_, without_near_;

 private:
  const std::string& name_of(std::uint32_t triangle) const {
    return asset_.nodes[asset_.joints[labels_[triangle]].node].name;
  }

  bool is_at_or_below(std::uint32_t node, const std::string& name) const {
    for (; node != asset::kNoParent; node = asset_.nodes[node].parent)
      if (asset_.nodes[node].name == name) return true;
    return false;
  }

  /// Where the palette moves the origin of a joint. Its inverse bind matrix is rigid.
  std::array<double, 3> origin_of(std::size_t joint) const {
    const auto& bind = asset_.joints[joint].inverse_bind.m;
    const auto& m = palette_[joint].m;
    std::array<double, 3> rest{}, posed{};
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t k = 0; k < 3; ++k) rest[row] -= bind[4 * row + k] * bind[12 + k];
    for (std::size_t row = 0; row < 3; ++row) {
      posed[row] = m[12 + row];
      for (std::size_t k = 0; k < 3; ++k) posed[row] += m[4 * k + row] * rest[k];
    }
    return posed;
  }

  std::vector<Matrix4> palette_;
  asset::SampleScratch samples_;
  Scratch scratch_;
};

TEST_F(Human, ArmInTheRibsCounts) {
  constexpr float kArmSwings = 19 / 30.0F;
  sample("walk", kArmSwings);
  EXPECT_EQ(contacts(*without_near_, "spine", "arm"), 0u);
  turn("upperarm01.R", 38);
  turn("lowerarm01.R", -110);  // the forearm points forwards, away from the body
  const std::size_t all = contacts(*without_near_, "spine", "upperarm");
  const std::size_t counted = contacts(*filter_, "spine", "upperarm");
  EXPECT_GT(counted, 15u);
  EXPECT_LT(counted, all) << "those at the armpit are dropped";
  EXPECT_EQ(contacts(*filter_, "upperarm", "lowerarm"), 0u) << "the crease of the elbow";
}

TEST_F(Human, CreasesOfClipsDoNotCount) {
  std::size_t creases = 0;
  for (const char* clip : {"walk", "punch_jab", "idle", "dance"})
    for (int frame = 0; frame < 40; frame += 3) {
      sample(clip, static_cast<float>(frame) / 30);
      for (const auto& [first, second] : {std::pair{"upperarm", "lowerarm"},
                                          {"upperleg", "lowerleg"},
                                          {"spine", "upperarm"},
                                          {"neck", "head"}}) {
        creases += contacts(*without_near_, first, second);
        EXPECT_EQ(contacts(*filter_, first, second), 0u)
            << clip << ", frame " << frame << ": " << first << ", " << second;
      }
    }
  EXPECT_GT(creases, 100u);
}

TEST_F(Human, ZonesNeedLessThanAByteATriangle) {
  const std::size_t bytes = filter_->memory_bytes() - without_near_->memory_bytes();
  EXPECT_LT(bytes, 3 * asset_.triangles.size()) << "including two bytes for the main joint";
}

}  // namespace
}  // namespace pelt::scenes
