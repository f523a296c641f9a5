#include <pelt/asset.hpp>
#include <pelt/self_filter.hpp>

#include "scenes/creature.hpp"
#include "scenes/triangle_labels.hpp"
#include "self/near_joints.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

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

namespace pelt::detail {
namespace {

/// A tube along x, of 8 sides, with rings 1 apart. Joint 0 moves the vertices up to x = 0, joint 1
/// the others. The nodes of the joints have the same numbers. Body 0 has the triangles left of 0.
class Tube {
 public:
  /// `first`, `last`: the ends. `radius`: of the ring at x.
  template <typename Radius>
  Tube(int first, int last, const Radius& radius) {
    asset_.influences_per_vertex = 1;
    for (int node = 0; node < 2; ++node) {
      asset_.nodes.emplace_back();
      asset_.joints.push_back({static_cast<std::uint32_t>(node), Matrix4{}});
    }
    asset_.nodes[1].parent = 0;
    for (int x = first; x <= last; ++x)
      for (int side = 0; side < kSides; ++side) {
        const double angle = 6.283185307179586 * side / kSides;
        const auto r = static_cast<double>(radius(x));
        add_vertex({static_cast<float>(x), static_cast<float>(r * std::cos(angle)),
                    static_cast<float>(r * std::sin(angle))},
                   x > 0 ? 1 : 0);
      }
    for (int x = first; x < last; ++x)
      for (int side = 0; side < kSides; ++side) {
        const auto at = [&](int ring, int s) {
          return static_cast<std::uint32_t>((ring - first) * kSides + s % kSides);
        };
        asset_.triangles.push_back({at(x, side), at(x + 1, side), at(x + 1, side + 1)});
        asset_.triangles.push_back({at(x, side), at(x + 1, side + 1), at(x, side + 1)});
        bodies_.insert(bodies_.end(), 2, x >= 0 ? 1 : 0);
      }
    for (std::uint32_t side = 0; side < kSides; ++side)
      borders_.vertices.push_back({1, static_cast<std::uint32_t>(-first * kSides) + side});
    borders_.pairs = {{1, 0}};
  }

  asset::Asset& asset() { return asset_; }
  Borders& borders() { return borders_; }
  const std::vector<std::uint16_t>& bodies() const { return bodies_; }
  JointZones zones() const {
    return joint_zones(scenes::default_positions(asset_), asset_.triangles, bodies_, borders_);
  }

  /// Expects that the zone of body 1 has the triangles with a corner at first <= x <= last.
  void expect_reach(int first, int last) const {
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t t = 0; t < asset_.triangles.size(); ++t)
      for (const std::uint32_t vertex : asset_.triangles[t])
        if (const float x = asset_.rest_positions[vertex].x;
            static_cast<float>(first) <= x && x <= static_cast<float>(last))
          expected.insert(t);
    for (const auto& [triangle, zone] : zones().triangles) {
      EXPECT_EQ(zone, 1);
      EXPECT_TRUE(found.insert(triangle).second) << "listed once";
    }
    EXPECT_EQ(found, expected);
    EXPECT_LT(expected.size(), asset_.triangles.size());
    EXPECT_EQ(zones().pair_count, 1u);
  }

 private:
  static constexpr int kSides = 8;

  void add_vertex(const Vec3& position, std::uint16_t joint) {
    asset_.rest_positions.push_back(position);
    asset_.joint_indices.push_back(joint);
    asset_.weights.push_back(1);
  }

  asset::Asset asset_;
  std::vector<std::uint16_t> bodies_;
  Borders borders_;
};

TEST(JointZones, ReachTwoAndAHalfRadiiOfTheBorder) {
  // Corners at x are sqrt(x^2 + 4^2) from the centre of the border.
  const Tube tube(-20, 20, [](int) { return 4; });
  tube.expect_reach(-9, 9);  // 9.85 < 10 < 10.77
}

TEST(JointZones, HaveTheThicknessOfThePieceIfItIsGreater) {
  const Tube tube(-40, 20, [](int x) { return x > 0 ? 6 : x == 0 ? 1 : 4; });
  // Of 20 * 16 triangles on the right, 24 corners are at the border and 936 are 6 from the axis.
  const double squared_reach = 6.25 * (24 * 1 + 936 * 36) / 960;
  const int left = static_cast<int>(std::sqrt(squared_reach - 16));
  const int right = static_cast<int>(std::sqrt(squared_reach - 36));
  EXPECT_LT(right, left);
  tube.expect_reach(-left, right);
}

TEST(JointZones, AreFoundInTheDefaultPose) {
  Tube tube(-20, 20, [](int) { return 4; });
  // The rest positions of the second half are elsewhere and much smaller, as of a part in a frame
  // of its own. The inverse bind matrix brings them back.
  const float scale = 0.01F, shift = 300;
  for (std::size_t v = 0; v < tube.asset().rest_positions.size(); ++v)
    if (tube.asset().joint_indices[v] == 1) {
      Vec3& p = tube.asset().rest_positions[v];
      p = {p.x * scale + shift, p.y * scale, p.z * scale};
    }
  Matrix4& back = tube.asset().joints[1].inverse_bind;
  back.m[0] = back.m[5] = back.m[10] = 1 / scale;
  back.m[12] = -shift / scale;
  const Tube whole(-20, 20, [](int) { return 4; });
  const auto of = [](const Tube& t) {
    std::set<std::uint32_t> triangles;
    for (const TriangleZone& z : t.zones().triangles) triangles.insert(z.triangle);
    return triangles;
  };
  EXPECT_EQ(of(tube), of(whole));
}

TEST(JointZones, DoNotDependOnTheBendOfTheJointNearTheBorder) {
  Tube tube(-20, 20, [](int) { return 4; });
  const std::size_t straight = tube.zones().triangles.size();
  tube.asset().nodes[1].local.rotation = {0, 0, 0.6F, 0.8F};  // 74 degrees
  const std::size_t bent = tube.zones().triangles.size();
  EXPECT_NEAR(static_cast<double>(bent), static_cast<double>(straight), 32) << "two rings of 16";
}

TEST(JointZones, OfTooManyPairsHaveALimitedCost) {
  Tube tube(-20, 20, [](int) { return 4; });
  // 400 bodies above body 1 that are all as large as body 0, which is possible only in this test.
  tube.borders().pairs.clear();
  for (int i = 0; i < 400; ++i) tube.borders().pairs.push_back({1, 0});
  const JointZones zones = tube.zones();
  EXPECT_EQ(zones.pair_count, 0u);
  EXPECT_TRUE(zones.triangles.empty());
}

}  // namespace
}  // namespace pelt::detail
