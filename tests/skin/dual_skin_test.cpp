#include "skin/dual_skin.hpp"

#include "model/unpack.hpp"
#include "pose/pose.hpp"
#include "skin/skin.hpp"
#include "support/dual_shapes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace pelt {
namespace {

using detail::DualQuaternion;
using detail::Palette;
using detail::SkinnedMesh;
using test::Random;
using test::Turns;
using test::Weights;

struct Posed {
  SkinnedModel model;
  SkinnedMesh mesh;
  Pose pose;

  Posed(const test::Shape& shape, const std::vector<Matrix4>& palette)
      : model(*build_model(shape.view(), test::kDual)),
        mesh(detail::unpack_mesh(model.detail().tree)),
        pose(model) {
    EXPECT_TRUE(pose.set_palette(palette));
  }

  const Palette& palette() const { return pose.detail().palette; }
};

std::vector<std::uint32_t> bits_of(const Vec3& v) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
          std::bit_cast<std::uint32_t>(v.z)};
}

template <typename Check>
void for_each_kind(std::uint64_t seed, Check check) {
  Random random(seed);
  for (const Turns turns : test::kAllTurns)
    for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
      for (const std::uint32_t influences : {1u, 2u, 4u, 16u})
        check(Posed(test::make_soup(random, 100, 20, influences, weights),
                    test::random_rigid_palette(random, 20, turns, 2)));
}

TEST(DualSkin, WideCodeHasTheBitsOfTheScalarDefinition) {
  for_each_kind(60, [](const Posed& posed) {
    std::vector<Vec3> all(posed.mesh.vertex_count());
    posed_vertices(posed.pose, all);
    for (std::uint32_t v = 0; v < posed.mesh.vertex_count(); ++v) {
      const auto expected = bits_of(pelt::scalar::posed_vertex(posed.mesh, posed.palette(), v));
      ASSERT_EQ(bits_of(detail::posed_vertex(posed.mesh, posed.palette(), v)), expected);
      ASSERT_EQ(bits_of(all[v]), expected);
    }
  });
}

TEST(DualSkin, OneRigidJointMovesLikeItsMatrix) {
  Random random(61);
  const test::Shape soup = test::make_soup(random, 200, 9, 1, Weights::one_joint);
  for (const Turns turns : test::kAllTurns) {
    const auto palette = test::random_rigid_palette(random, 9, turns, 2);
    const Posed dual(soup, palette);
    Pose linear(*build_model(soup.view()));
    ASSERT_TRUE(linear.set_palette(palette));
    std::vector<Vec3> a(soup.rest_positions.size()), b(a.size());
    posed_vertices(dual.pose, a);
    posed_vertices(linear, b);
    const float rounding = 64 * 0x1p-24f * dual.palette().extent();
    for (std::size_t v = 0; v < a.size(); ++v)
      for (const float error : {a[v].x - b[v].x, a[v].y - b[v].y, a[v].z - b[v].z})
        ASSERT_LE(std::fabs(error), rounding);
  }
}

/// Smallest distance of a ring's vertices from the axis of a twisted limb, relative to the rest.
float thinnest(const ModelOptions& options) {
  const test::Shape limb = test::make_limb(40, 12, 2);
  Pose pose(*build_model(limb.view(), options));
  EXPECT_TRUE(pose.set_palette(test::twist_limb(2, 3.1, {})));
  std::vector<Vec3> posed(limb.rest_positions.size());
  posed_vertices(pose, posed);
  float least = 1;
  for (std::size_t v = 0; v < posed.size(); ++v) {
    const Vec3& rest = limb.rest_positions[v];
    if (const float radius = std::hypot(rest.x, rest.z); radius > 0.01f)
      least = std::min(least, std::hypot(posed[v].x, posed[v].z) / radius);
  }
  return least;
}

TEST(DualSkin, TwistedLimbDoesNotCollapse) {
  EXPECT_LT(thinnest({}), 0.2f) << "linear blend skinning must collapse";
  EXPECT_GT(thinnest(test::kDual), 0.999f);
}

TEST(DualSkin, SignOfAQuaternionDoesNotMatter) {
  Random random(62);
  const test::Shape soup = test::make_soup(random, 100, 9, 4, Weights::random);
  Posed posed(soup, test::random_rigid_palette(random, 9, Turns::large, 2));
  std::vector<Vec3> before(soup.rest_positions.size()), after(before.size());
  posed_vertices(posed.pose, before);
  std::vector<float> floats;
  for (const DualQuaternion& q : posed.palette().duals()) {
    const float sign = random.chance(0.5) ? -1.0f : 1.0f;
    for (const auto* part : {&q.real, &q.dual})
      for (const float f : *part) floats.push_back(sign * f);
  }
  ASSERT_TRUE(posed.pose.set_dual_quaternions(floats));
  posed_vertices(posed.pose, after);
  for (std::size_t v = 0; v < before.size(); ++v)
    for (const float error :
         {before[v].x - after[v].x, before[v].y - after[v].y, before[v].z - after[v].z})
      ASSERT_LE(std::fabs(error), 2000 * 0x1p-24f * posed.palette().extent());
}

TEST(DualSkin, InfluenceWithTheLargestWeightComesFirst) {
  test::Shape limb = test::make_limb(10, 5, 3);
  const SkinnedModel model = *build_model(limb.view(), test::kDual);
  const SkinnedMesh mesh = detail::unpack_mesh(model.detail().tree);
  EXPECT_EQ(model.skinning(), Skinning::dual_quaternion);
  int moved = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto influences = mesh.influences_of(v);
    for (const auto& influence : influences) {
      ASSERT_LE(influence.weight, influences[0].weight);
      if (influence.weight == influences[0].weight) {
        ASSERT_LE(influences[0].joint, influence.joint);
      }
      moved += influence.joint < influences[0].joint;
    }
  }
  EXPECT_GT(moved, 10);
}

std::string error_of(const Result<void>& result) {
  return result ? std::string() : result.error().message;
}

TEST(DualSkin, PalettesThatAreNotRigidAreRefusedByJoint) {
  const test::Shape limb = test::make_limb(10, 5, 3);
  Pose pose(*build_model(limb.view(), test::kDual));
  std::vector<Matrix4> palette(3);
  palette[1].m[0] = 1.0005f;  // its square is off by more than 2^-10
  EXPECT_NE(error_of(pose.set_palette(palette)).find("palette[1] is not rigid"), std::string::npos);
  palette[1].m[0] = 1.0004f;
  EXPECT_TRUE(pose.set_palette(palette));
  palette[1].m[0] = -1;
  EXPECT_NE(error_of(pose.set_palette(palette)).find("palette[1] mirrors"), std::string::npos);
  palette[1].m[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(error_of(pose.set_palette(palette)).find("palette[1] has the element nan"),
            std::string::npos);
  palette[1] = Matrix4();
  palette[2].m[13] = 0x1p59f;
  EXPECT_NE(error_of(pose.set_palette(palette)).find("palette[2] can move a vertex beyond"),
            std::string::npos);
}

TEST(DualSkin, DualQuaternionsAreValidatedByJoint) {
  const test::Shape limb = test::make_limb(10, 5, 2);
  Pose pose(*build_model(limb.view(), test::kDual));
  const std::vector<float> good = {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0};
  ASSERT_TRUE(pose.set_dual_quaternions(good));
  const auto with = [&](std::size_t i, float value) {
    std::vector<float> floats = good;
    floats[i] = value;
    return error_of(pose.set_dual_quaternions(floats));
  };
  EXPECT_NE(with(11, 0).find("dual_quaternions[1] has a real part of squared length 0"),
            std::string::npos);
  EXPECT_NE(with(14, HUGE_VALF).find("dual_quaternions[1] has the element inf"), std::string::npos);
  EXPECT_NE(with(5, std::numeric_limits<float>::quiet_NaN()).find("dual_quaternions[0]"),
            std::string::npos);
  EXPECT_NE(with(4, 0x1p62f).find("[0] can move a vertex beyond"), std::string::npos);
  EXPECT_NE(error_of(pose.set_dual_quaternions(std::span(good).first(8))).find("expected 16"),
            std::string::npos);
  Pose linear(*build_model(limb.view()));
  EXPECT_NE(error_of(linear.set_dual_quaternions(good)).find("Skinning::dual_quaternion"),
            std::string::npos);
}

TEST(DualSkin, TooManyInfluencesOfAVertexAreRefused) {
  test::Shape shape;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}};
  shape.influences_per_vertex = shape.joint_count = 17;
  shape.weights.assign(3 * 17, 1.0f / 17);
  for (std::size_t i = 0; i < shape.weights.size(); ++i)
    shape.joints.push_back(static_cast<std::uint16_t>(i % 17));
  EXPECT_TRUE(build_model(shape.view()));
  const auto model = build_model(shape.view(), test::kDual);
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find(
                "vertex 0 follows 17 joints, but dual quaternion skinning allows 16"),
            std::string::npos)
      << model.error().message;
}

}  // namespace
}  // namespace pelt
