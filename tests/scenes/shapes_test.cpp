#include "scenes/demo.hpp"

#include <pelt/pelt.hpp>
#include <pelt/pose.hpp>

#include "base/vec3.hpp"
#include "scenes/character_glb.hpp"
#include "scenes/creature.hpp"
#include "scenes/smooth_normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelt::scenes {
namespace {

TEST(Sword, IsClosedAndValid) {
  const asset::Asset sword = make_sword();
  EXPECT_EQ(sword.triangles.size(), 26u);
  const auto model = build_model(sword.mesh());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->surface().is_closed());
}

TEST(Sword, IsTheSameFromItsFile) {
  const asset::Asset sword = make_sword();
  const auto loaded = asset::load_gltf(character_glb(sword), {});
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->rest_positions, sword.rest_positions);
  EXPECT_EQ(loaded->triangles, sword.triangles);
  EXPECT_EQ(loaded->joints.size(), 1u);
  ASSERT_NE(loaded->find_clip("swing"), nullptr);
  EXPECT_EQ(loaded->find_clip("swing")->duration, 0.4f);
}

/// Returns the posed tip at a time.
Vec3 tip_at(const asset::Asset& sword, const SkinnedModel& model, float seconds) {
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(1);
  asset::sample_palette(sword, sword.find_clip("swing"), seconds, Matrix4(), scratch, palette);
  Pose pose(model);
  EXPECT_TRUE(pose.set_palette(palette));
  std::vector<Vec3> positions(model.vertex_count());
  posed_vertices(pose, positions);
  return positions.back();
}

TEST(Sword, SwingsFromFrontToBack) {
  const asset::Asset sword = make_sword();
  const auto model = build_model(sword.mesh());
  ASSERT_TRUE(model);
  EXPECT_NEAR(tip_at(sword, *model, 0).z, 0.9f, 1e-6f);
  EXPECT_NEAR(tip_at(sword, *model, 0.1f + 1.0f / 12).x, -0.9f, 1e-6f);
  EXPECT_NEAR(tip_at(sword, *model, 0.3f).z, -0.9f, 1e-6f);
}

// A twisted forearm collapses with linear blend skinning, like the wrapper of a sweet, but not
// with dual quaternions.

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

/// A roof: two faces with the ridge 1-2. The second face is twice as large and has copies of the
/// ridge's vertices, 4 and 5. Also a vertex that no triangle uses, and a collapsed triangle.
const std::vector<Vec3> kRoof = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, -2},
                                 {0, 0, 0},  {0, 1, 0}, {7, 7, 7}, {5, 5, 5}};
const std::vector<Triangle> kFaces = {{0, 1, 2}, {4, 3, 5}, {7, 7, 7}};

std::vector<Vec3> normals_of_roof(const std::vector<std::uint32_t>& seams) {
  std::vector<Vec3> normals(kRoof.size());
  smooth_normals(kRoof, kFaces, seams, normals);
  return normals;
}

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-6);
  EXPECT_NEAR(found.y, expected.y, 1e-6);
  EXPECT_NEAR(found.z, expected.z, 1e-6);
}

TEST(SmoothNormals, AreThoseOfTheTrianglesWhereNothingIsShared) {
  const std::vector<Vec3> normals = normals_of_roof({0, 1, 2, 3, 4, 5, 6, 7});
  for (const int v : {0, 1, 2}) expect_near(normals[v], {0, 0, 1});
  for (const int v : {3, 4, 5}) expect_near(normals[v], {1, 0, 0});
}

TEST(SmoothNormals, AreWeightedByAreaAcrossASeam) {
  const std::vector<Vec3> normals = normals_of_roof({0, 1, 2, 3, 1, 2, 6, 7});
  const float root = std::sqrt(5.0f);
  for (const int v : {1, 2, 4, 5}) expect_near(normals[v], {2 / root, 0, 1 / root});
  expect_near(normals[0], {0, 0, 1});
  expect_near(normals[3], {1, 0, 0});
}

TEST(SmoothNormals, PointUpWhereThereIsNothingToGoBy) {
  const std::vector<Vec3> normals = normals_of_roof({0, 1, 2, 3, 4, 5, 6, 7});
  expect_near(normals[6], {0, 1, 0});
  expect_near(normals[7], {0, 1, 0});
}

}  // namespace
}  // namespace pelt::scenes
