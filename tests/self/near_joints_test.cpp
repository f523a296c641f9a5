#include <pelt/asset.hpp>
#include <pelt/self_filter.hpp>

#include "scenes/creature.hpp"
#include "scenes/triangle_labels.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace pelt::test {
namespace {

using Numbers = std::vector<std::uint16_t>;

TEST(NearJoints, OfAModelAreThoseOfItsAsset) {
  const asset::Asset asset = *scenes::make_creature(scenes::kDwarf);
  const SkinnedModel model = *build_model(asset.mesh(), {.off_weights = OffWeights::renormalise});
  const std::vector<Contact> at_rest = {{0, model.triangle_count() - 1}};
  const Result<NearJoints> found =
      near_joints(model, asset::joint_bodies(asset), scenes::default_positions(asset), at_rest);
  ASSERT_TRUE(found) << found.error().message;
  const NearJoints expected =
      scenes::near_joints(asset, scenes::label_triangles(asset)->joint, at_rest);
  EXPECT_EQ(found->bodies, expected.bodies);
  EXPECT_EQ(found->joint_pairs, expected.joint_pairs);
  EXPECT_EQ(found->joint_pairs_in_zones, expected.joint_pairs_in_zones);
  ASSERT_EQ(found->zones.size(), expected.zones.size());
  for (std::size_t i = 0; i < expected.zones.size(); ++i) {
    EXPECT_EQ(found->zones[i].triangle, expected.zones[i].triangle);
    EXPECT_EQ(found->zones[i].zone, expected.zones[i].zone);
  }
  EXPECT_GT(expected.joint_pairs.size(), 5u);
  EXPECT_GT(expected.joint_pairs_in_zones.size(), 5u);
  EXPECT_GT(expected.zones.size(), 100u);
}

/// A limb of three joints in a chain.
class Limb : public testing::Test {
 protected:
  void refuse(const char* message, const JointBodies& bodies,
              const std::vector<Vec3>& positions = {}, const std::vector<Contact>& at_rest = {}) {
    const Result<NearJoints> found = near_joints(model_, bodies, positions, at_rest);
    ASSERT_FALSE(found) << message;
    EXPECT_NE(found.error().message.find(message), std::string::npos) << found.error().message;
  }

  const Shape shape_ = make_limb(12, 8, 3);
  const SkinnedModel model_ = *build_model(shape_.view());
  const JointBodies chain_ = bodies_of_parents(Numbers{kNoJoint, 0, 1});
};

TEST_F(Limb, HasNearPairsInZonesAtItsJoints) {
  const NearJoints near = *near_joints(model_, chain_, {}, {});
  EXPECT_EQ(near.bodies, (Numbers{0, 1, 2}));
  EXPECT_EQ(near.joint_pairs, (std::vector<IndexPair>{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_EQ(near.joint_pairs_in_zones, (std::vector<IndexPair>{{1, 0}, {2, 1}}));
  EXPECT_FALSE(near.zones.empty());
}

TEST_F(Limb, OfOneBodyIsNearItself) {
  const NearJoints near = *near_joints(model_, {{0, 0, 0}, Numbers(3, kNoJoint)}, {}, {});
  EXPECT_EQ(near.joint_pairs, (std::vector<IndexPair>{{0, 0}}));
  EXPECT_TRUE(near.joint_pairs_in_zones.empty());
}

/// Joints 1 and 2 are one body, but their weights are not added.
TEST(NearJoints, ATriangleBelongsToTheBodyOfItsMainJoint) {
  Shape shape;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  shape.triangles = {{0, 1, 2}, {3, 4, 5}};
  shape.influences_per_vertex = 3;
  shape.joint_count = 3;
  for (int i = 0; i < 6; ++i) {
    shape.joints.insert(shape.joints.end(), {0, 1, 2});
    if (i < 3) shape.weights.insert(shape.weights.end(), {0.4f, 0.3f, 0.3f});
    if (i >= 3) shape.weights.insert(shape.weights.end(), {0, 1, 0});
  }
  const SkinnedModel model = *build_model(shape.view());
  const NearJoints near = *near_joints(model, {{0, 1, 1}, {kNoJoint, 0, 0}}, {}, {});
  EXPECT_EQ(near.joint_pairs, (std::vector<IndexPair>{{0, 0}, {1, 0}, {1, 1}}));

  SelfFilterOptions options;
  const Numbers bodies = {0, 1, 1};
  const std::vector<IndexPair> pairs = {{0, 1}};
  options.joint_bodies = bodies;
  options.joint_pairs = pairs;
  EXPECT_EQ(build_self_filter(model, options)->left_out_by(0, 1), LeftOutBy::joints);
  const std::vector<IndexPair> others = {{1, 1}};
  options.joint_pairs = others;
  EXPECT_EQ(build_self_filter(model, options)->left_out_by(0, 1), LeftOutBy::none);
}

TEST_F(Limb, RefusesBodies) {
  refuse("the bodies are of 2 and 3 joints, but the model has 3 joints", {{0, 1}, chain_.above});
  refuse("the bodies are of 3 and 0 joints", {chain_.of_joints, {}});
  refuse("of_joints[0] is 1, expected the lowest joint", {{1, 1, 2}, chain_.above});
  refuse("of_joints[2] is 1, expected the lowest joint", {{0, 0, 1}, Numbers(3, kNoJoint)});
  refuse("above[1] is 3, expected a body", bodies_of_parents(Numbers{kNoJoint, 3, 1}));
  refuse("above[2] is 1, expected a body", {{0, 0, 2}, {kNoJoint, kNoJoint, 1}});
  refuse("above[1] is 2, but above[0], of the same body, is 65535", {{0, 0, 2}, {kNoJoint, 2, 0}});
}

TEST_F(Limb, RefusesBodiesAboveThemselves) {
  refuse("body 0 is above itself", bodies_of_parents(Numbers{0, 0, 1}));
  refuse("is above itself", bodies_of_parents(Numbers{2, 0, 1}));
  refuse("is above itself", bodies_of_parents(Numbers{kNoJoint, 2, 1}));
}

TEST_F(Limb, RefusesPositionsAndContacts) {
  refuse("positions has 1 elements", chain_, {Vec3{}});
  std::vector<Vec3> positions(model_.vertex_count());
  positions[5].y = std::numeric_limits<float>::quiet_NaN();
  refuse("positions[5] is not finite", chain_, positions);
  refuse("at_rest[1] refers to triangle 999999", chain_, {}, {{0, 1}, {2, 999999}});
}

}  // namespace
}  // namespace pelt::test
