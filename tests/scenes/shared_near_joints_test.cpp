/// The near joints of a real character leave out the creases of its clips, but not an upper arm
/// that is turned into the ribs.

#include "scenes/triangle_labels.hpp"

#include <pelt/pelt.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pelt::scenes {
namespace {

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
