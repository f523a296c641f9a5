/// A twisted forearm collapses with linear blend skinning, like the wrapper of a sweet, but not
/// with dual quaternions.

#include "scenes/demo.hpp"

#include "base/vec3.hpp"
#include "scenes/creature.hpp"

#include <pelt/pose.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pelt::scenes {
namespace {

using detail::Vec3d;

constexpr double kTurns = 0.49;

const asset::Asset& creature() {
  static const asset::Asset asset = *make_creature(kMan);
  return asset;
}

Vec3d elbow() {
  for (std::uint32_t j = 0; j < creature().joints.size(); ++j)
    if (creature().joint_name(j) == "fore_arm_l") {
      const auto& m = creature().joints[j].inverse_bind.m;
      return {-double{m[12]}, -double{m[13]}, -double{m[14]}};
    }
  return {};
}

/// Smallest distance of a posed vertex of the arm from the elbow, which lies inside the arm.
double thinnest(const ModelOptions& options, double turns) {
  Pose pose(*build_model(creature().mesh(), options));
  EXPECT_TRUE(pose.set_palette(twisted_arm(creature(), turns)));
  EXPECT_EQ(check_bounds(pose), "");
  std::vector<Vec3> posed(creature().rest_positions.size());
  posed_vertices(pose, posed);
  double least = 1;
  for (const Vec3& v : posed)
    least = std::min(least, std::sqrt(squared_length(Vec3d(v) - elbow())));
  return least;
}

TEST(TwistedArm, CollapsesOnlyWithLinearBlendSkinning) {
  const double at_rest = thinnest({}, 0);
  ASSERT_GT(at_rest, 0.02);
  EXPECT_LT(thinnest({}, kTurns), 0.5 * at_rest);
  EXPECT_GT(thinnest({.skinning = Skinning::dual_quaternion}, kTurns), 0.95 * at_rest);
}

}  // namespace
}  // namespace pelt::scenes
