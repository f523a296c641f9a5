#include "scenes/triangle_labels.hpp"

#include "model/surface.hpp"
#include "scenes/creature.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace pelt::scenes {
namespace {

/// One joint has the largest sum without being the largest of any vertex; also two parts.
asset::Asset three_triangles() {
  asset::Asset asset;
  asset.rest_positions.resize(9, Vec3{0, 0, 0});
  asset.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  asset.influences_per_vertex = 2;
  for (int v = 0; v < 9; ++v) asset.joint_indices.insert(asset.joint_indices.end(), {0, 1});
  asset.weights = {0.4f, 0.6f, 0.9f, 0.1f, 0.4f, 0.6f, 0,    1,    0,
                   1,    0,    1,    0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
  asset.joints.resize(2);
  asset.parts.resize(2);
  asset.parts[0].triangle_count = 2;
  asset.parts[1] = {"", "", "", 2, 1, true};
  return asset;
}

TEST(TriangleLabels, AreTheJointOfTheGreatestSumAndThePart) {
  const auto labels = label_triangles(three_triangles());
  ASSERT_TRUE(labels) << labels.error().message;
  EXPECT_EQ(labels->joint, (std::vector<std::uint16_t>{0, 1, 0}));
  EXPECT_EQ(labels->part, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(TriangleLabels, TakeWeightsThatDoNotSumToOneAndRefuseWhatIsNoWeight) {
  asset::Asset asset = three_triangles();
  for (float& weight : asset.weights) weight *= 3;
  ASSERT_TRUE(label_triangles(asset));
  EXPECT_EQ(label_triangles(asset)->joint, (std::vector<std::uint16_t>{0, 1, 0}));
  asset.weights[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(label_triangles(asset));
}

TEST(TriangleLabels, NameTheJointsThatContactsNameToo) {
  const Result<asset::Asset> creature = make_creature({.triangles = 2000, .joints = 56, .seed = 3});
  ASSERT_TRUE(creature);
  const Result<SkinnedModel> model = build_model(creature->mesh());
  ASSERT_TRUE(model);
  const auto labels = label_triangles(*creature);
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->joint, detail::Surface(*model).joints);
  EXPECT_GT(std::set(labels->joint.begin(), labels->joint.end()).size(), 20u);
}

}  // namespace
}  // namespace pelt::scenes
