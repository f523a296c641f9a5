#include "scenes/creature/skin_weights.hpp"

#include "scenes/creature/polygonise.hpp"
#include "scenes/creature/skeleton.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace pelt::scenes {
namespace {

std::map<std::string, double> named_weights(const BodyPlan& plan, const VertexWeights& vertex) {
  std::map<std::string, double> result;
  for (std::uint32_t k = 0; k < kInfluences; ++k) {
    if (vertex.weights[k] > 0) result[plan.joints[vertex.joints[k]].name] += vertex.weights[k];
  }
  return result;
}

class Skin : public testing::Test {
 protected:
  BodyPlan plan_ = make_body_plan(draw_proportions(1));
  std::vector<std::uint32_t> all_ = choose_joints(plan_, kPlanJoints);
  SkinWeights skin_{plan_, all_};
};

TEST_F(Skin, MiddleOfALimbFollowsItsJointAlone) {
  const Vec3d knee = plan_.joints[find_joint(plan_, "shin_l")].position;
  const Vec3d ankle = plan_.joints[find_joint(plan_, "foot_l")].position;
  Vec3d p = mix(knee, ankle, 0.5) + Vec3d(0.06, 0, 0);
  project_on_flesh(plan_.flesh, p);
  EXPECT_GT(named_weights(plan_, skin_.at(p))["shin_l"], 0.95);
}

TEST_F(Skin, KneeSharesThighAndShinAndNothingOfTheOtherLeg) {
  Vec3d p = plan_.joints[find_joint(plan_, "shin_l")].position + Vec3d(0, 0, 0.1);
  project_on_flesh(plan_.flesh, p);
  std::map<std::string, double> weights = named_weights(plan_, skin_.at(p));
  EXPECT_GT(weights["thigh_l"], 0.2);
  EXPECT_GT(weights["shin_l"], 0.2);
  for (const auto& [name, weight] : weights) EXPECT_EQ(name.find("_r"), std::string::npos) << name;
}

// Over the whole skin: weights of neighbours differ little, left and right never share a limb, and
// fingers never follow other fingers, only the hand.
TEST_F(Skin, WeightsAreSmoothAndLocal) {
  const double spacing = 0.016;
  const RawMesh mesh = polygonise(plan_.flesh, spacing);
  std::vector<std::map<std::string, double>> weights;
  std::set<std::string> used;
  for (const Vec3d& p : mesh.positions) {
    weights.push_back(named_weights(plan_, skin_.at(p)));
    double sum = 0;
    bool left = false, right = false;
    for (const auto& [name, weight] : weights.back()) {
      sum += weight;
      used.insert(name);
      left = left || (name == "shin_l" || name == "upper_arm_l");
      right = right || (name == "shin_r" || name == "upper_arm_r");
    }
    ASSERT_NEAR(sum, 1, 1e-12);
    ASSERT_FALSE(left && right);
  }
  EXPECT_EQ(used.size(), kPlanJoints);
  double steepest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto &a = weights[t[i]], &b = weights[t[(i + 1) % 3]];
      const double way = length(mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]);
      for (const auto& [name, weight] : a) {
        const auto other = b.find(name);
        const double step = std::abs(weight - (other == b.end() ? 0 : other->second));
        steepest = std::max(steepest, step / std::max(way, 0.25 * spacing));
      }
    }
  }
  EXPECT_LT(steepest, 200);  // at the clefts between the toes
  EXPECT_GT(steepest, 20);
}

TEST(Skeleton, EveryCountIsMetSymmetricallyAndNested) {
  const BodyPlan plan = make_body_plan({});
  for (std::uint32_t count = kBaseJoints; count <= kPlanJoints; ++count) {
    const std::vector<std::uint32_t> stands_for = choose_joints(plan, count);
    std::uint32_t kept = 0;
    for (std::uint32_t j = 0; j < kPlanJoints; ++j) {
      kept += stands_for[j] == j;
      EXPECT_EQ(stands_for[stands_for[j]], stands_for[j]);
      std::string name = plan.joints[j].name;
      if (name.size() < 2 || name.substr(name.size() - 2) != "_l") continue;
      name.back() = 'r';
      const std::uint32_t mirror = find_joint(plan, name);
      EXPECT_EQ(stands_for[j] == j, stands_for[mirror] == mirror) << count << " " << name;
    }
    EXPECT_EQ(kept, count);
  }
}

}  // namespace
}  // namespace pelt::scenes
