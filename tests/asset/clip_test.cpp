#include <pelt/asset.hpp>

#include "asset/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pelt::asset {
namespace {

Matrix4 translation(float x, float y, float z) {
  Matrix4 matrix;
  matrix.m[12] = x;
  matrix.m[13] = y;
  matrix.m[14] = z;
  return matrix;
}

Vec3 transformed(const Matrix4& m, const Vec3& v) {
  return {m.m[0] * v.x + m.m[4] * v.y + m.m[8] * v.z + m.m[12],
          m.m[1] * v.x + m.m[5] * v.y + m.m[9] * v.z + m.m[13],
          m.m[2] * v.x + m.m[6] * v.y + m.m[10] * v.z + m.m[14]};
}

void expect_near(const Vec3& v, const Vec3& expected) {
  EXPECT_NEAR(v.x, expected.x, 1e-6);
  EXPECT_NEAR(v.y, expected.y, 1e-6);
  EXPECT_NEAR(v.z, expected.z, 1e-6);
}

// An arm along x: shoulder at the origin, elbow at x = 2, and a clip that bends the elbow by 90
// degrees about z within a second.
Asset arm() {
  const float half = std::sqrt(0.5f);
  Asset asset;
  asset.nodes.resize(2);
  asset.nodes[1].parent = 0;
  asset.nodes[1].local.translation = {2, 0, 0};
  asset.joints = {{0, {}}, {1, translation(-2, 0, 0)}};
  asset.clips.push_back(
      {"bend",
       1,
       {{1, Path::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, half, half}}}});
  return asset;
}

std::vector<Matrix4> palette_of(const Asset& asset, const Clip* clip, float seconds,
                                const Matrix4& placement = {}) {
  SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  sample_palette(asset, clip, seconds, placement, scratch, palette);
  return palette;
}

TEST(SamplePalette, WithoutClipIsTheDefaultPose) {
  for (const Matrix4& matrix : palette_of(arm(), nullptr, 5)) EXPECT_EQ(matrix, Matrix4());
}

TEST(SamplePalette, ClipMovesItsJointAboutTheJointsPlace) {
  const Asset asset = arm();
  const std::vector<Matrix4> palette = palette_of(asset, &asset.clips[0], 1);
  EXPECT_EQ(palette[0], Matrix4());
  expect_near(transformed(palette[1], {3, 0, 0}), {2, 1, 0});
  const std::vector<Matrix4> halfway = palette_of(asset, &asset.clips[0], 0.5f);
  const float c = std::sqrt(0.5f);
  expect_near(transformed(halfway[1], {3, 0, 0}), {2 + c, c, 0});
}

TEST(SamplePalette, PlacementStandsBeforeEverything) {
  const Asset asset = arm();
  Matrix4 placement = translation(10, 20, 30);
  placement.m[0] = -3;  // a reflection that scales
  const std::vector<Matrix4> palette = palette_of(asset, &asset.clips[0], 1, placement);
  expect_near(transformed(palette[1], {3, 0, 0}), {4, 21, 30});
}

TEST(SamplePalette, ChildrenInheritRotationAndScaleOfTheirParents) {
  Asset asset = arm();
  asset.nodes[0].local.scale = {1, 5, 1};
  asset.nodes[0].local.translation = {0, 0, 7};
  const std::vector<Matrix4> palette = palette_of(asset, &asset.clips[0], 1);
  expect_near(transformed(palette[1], {3, 0, 0}), {2, 5, 7});
}

TEST(SamplePalette, TransformIsTranslationTimesRotationTimesScale) {
  Asset asset = arm();
  asset.nodes[0].local = {{1, 2, 3}, {0.5f, 0.5f, 0.5f, 0.5f}, {2, 3, 4}};  // x -> y -> z -> x
  const std::vector<Matrix4> palette = palette_of(asset, nullptr, 0);
  expect_near(transformed(palette[0], {1, 1, 1}), {1 + 4, 2 + 2, 3 + 3});
}

TEST(SamplePalette, MatrixNodesTakeTheirMatrix) {
  Asset asset = arm();
  asset.nodes[0].has_matrix = true;
  asset.nodes[0].matrix = translation(0, 4, 0);
  asset.nodes[0].matrix.m[4] = 0.5f;  // a shear, which no Transform can represent
  const std::vector<Matrix4> palette = palette_of(asset, &asset.clips[0], 1);
  expect_near(transformed(palette[0], {1, 2, 3}), {2, 6, 3});
  expect_near(transformed(palette[1], {3, 0, 0}), {2.5f, 5, 0});
}

TEST(SamplePalette, AnimatesTranslationAndScale) {
  Asset asset = arm();
  asset.clips[0].channels.push_back(
      {0, Path::translation, Interpolation::linear, {0, 2}, {0, 0, 0, 0, 0, 8}});
  asset.clips[0].channels.push_back({0, Path::scale, Interpolation::step, {0}, {2, 2, 2}});
  const std::vector<Matrix4> palette = palette_of(asset, &asset.clips[0], 1);
  expect_near(transformed(palette[1], {3, 0, 0}), {4, 2, 4});
}

TEST(SamplePalette, ZeroLengthClipIsOnePose) {
  Asset asset = arm();
  const float half = std::sqrt(0.5f);
  asset.clips = {{"", 0, {{1, Path::rotation, Interpolation::linear, {0}, {0, 0, half, half}}}}};
  for (float seconds : {0.0f, 3.0f}) {
    const std::vector<Matrix4> palette = palette_of(asset, &asset.clips[0], seconds);
    expect_near(transformed(palette[1], {3, 0, 0}), {2, 1, 0});
  }
}

TEST(SamplePalette, LastRowsAreExact) {
  Asset asset = arm();
  asset.joints[0].inverse_bind.m[15] = 0.9999999f;  // as written by some exporters
  for (const Matrix4& matrix : palette_of(asset, &asset.clips[0], 0.3f)) {
    EXPECT_EQ(matrix.m[3], 0);
    EXPECT_EQ(matrix.m[7], 0);
    EXPECT_EQ(matrix.m[11], 0);
    EXPECT_EQ(matrix.m[15], 1);
  }
}

TEST(SamplePalette, ScratchCarriesNothingOver) {
  const Asset asset = arm();
  SampleScratch scratch;
  std::vector<Matrix4> first(2), second(2);
  sample_palette(asset, nullptr, 0, {}, scratch, first);
  sample_palette(asset, &asset.clips[0], 1, translation(1, 2, 3), scratch, second);
  sample_palette(asset, nullptr, 0, {}, scratch, second);
  EXPECT_EQ(first, second);
}

// Twenty links of a chain, each slightly rotated: the end equals the sum of the links.
TEST(SamplePalette, LongChainsKeepTheirPrecision) {
  Asset asset;
  const float angle = 0.3f;
  double x = 0, y = 0;
  for (std::uint32_t n = 0; n < 20; ++n) {
    Node node;
    node.parent = n == 0 ? kNoParent : n - 1;
    node.local.translation = {n == 0 ? 0.0f : 1.0f, 0, 0};
    node.local.rotation = {0, 0, std::sin(angle / 2), std::cos(angle / 2)};
    asset.nodes.push_back(node);
    asset.joints.push_back({n, {}});
    x += n < 19 ? std::cos(double{angle} * (n + 1)) : 0;
    y += n < 19 ? std::sin(double{angle} * (n + 1)) : 0;
  }
  const std::vector<Matrix4> palette = palette_of(asset, nullptr, 0);
  EXPECT_NEAR(palette[19].m[12], x, 5e-6);
  EXPECT_NEAR(palette[19].m[13], y, 5e-6);
}

TEST(Angles, SineAgreesWithLibm) {
  for (int i = -100000; i <= 100000; ++i) {
    const double x = i / 100000.0 * (kPi / 2);
    ASSERT_NEAR(sine(x), std::sin(x), 3e-16) << x;
  }
}

TEST(Angles, TurnsAgreeWithLibmAndArePeriodic) {
  for (int i = -30000; i <= 30000; ++i) {
    const double turns = i / 10000.0;
    ASSERT_NEAR(sine_of_turns(turns), std::sin(2 * kPi * turns), 4e-15) << turns;
    ASSERT_NEAR(cosine_of_turns(turns), std::cos(2 * kPi * turns), 4e-15) << turns;
  }
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(sine_of_turns(i / 64.0), sine_of_turns(i / 64.0 + 5));
    EXPECT_EQ(cosine_of_turns(i / 64.0), cosine_of_turns(i / 64.0 - 3));
  }
}

TEST(Angles, QuartersOfATurnAreExact) {
  EXPECT_EQ(sine_of_turns(0), 0);
  EXPECT_NEAR(sine_of_turns(0.25), 1, 1e-15);
  EXPECT_NEAR(cosine_of_turns(0.25), 0, 1e-15);
  EXPECT_NEAR(cosine_of_turns(0.5), -1, 1e-15);
}

TEST(Angles, AngleOfAgreesWithLibmOverTheWholeQuarter) {
  for (int i = 0; i <= 100000; ++i) {
    const double angle = i / 100000.0 * (kPi / 2);
    const double s = std::sin(angle), c = std::max(0.0, std::cos(angle));
    ASSERT_NEAR(angle_of(s, c), angle, 1e-15) << angle;
    ASSERT_NEAR(angle_of(0.125 * s, 0.125 * c), angle, 1e-15) << angle;
  }
}

Quaternion random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return normalised({normal(random), normal(random), normal(random), normal(random)});
}

Quaternion libm_slerp(const Quaternion& a, Quaternion b, double t) {
  if (dot(a, b) < 0) b = {-b.x, -b.y, -b.z, -b.w};
  const double angle = std::acos(std::min(1.0, dot(a, b)));
  const double s = std::sin(angle);
  return blend(a, std::sin((1 - t) * angle) / s, b, std::sin(t * angle) / s);
}

TEST(Quaternion, SlerpAgreesWithLibmOnTheShorterWay) {
  constexpr std::uint64_t kSeed = 20050301;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> unit(0, 1);
  int longer_way = 0;
  for (int i = 0; i < 20000; ++i) {
    const Quaternion a = random_rotation(random), b = random_rotation(random);
    const double t = unit(random);
    longer_way += dot(a, b) < 0;
    const Quaternion expected = libm_slerp(a, b, t), q = slerp(a, b, t);
    ASSERT_NEAR(squared_length(detail::Vec3d(q.x - expected.x, q.y - expected.y, q.z - expected.z)),
                0, 1e-24);
    ASSERT_NEAR(q.w, expected.w, 1e-12);
  }
  EXPECT_GT(longer_way, 8000);
}

TEST(Quaternion, SlerpOfNearlyEqualAndOppositeStaysAUnitQuaternion) {
  for (double distance = 1e-18; distance < 0.1; distance *= 3) {
    const Quaternion a = normalised({0.3, -0.5, 0.1, 0.8});
    const Quaternion b = normalised({a.x + distance, a.y, a.z, a.w});
    for (double sign : {1.0, -1.0}) {
      const Quaternion q = slerp(a, {sign * b.x, sign * b.y, sign * b.z, sign * b.w}, 0.25);
      ASSERT_NEAR(dot(q, q), 1, 1e-12);
      ASSERT_NEAR(q.x, a.x + 0.25 * (b.x - a.x),
                  1e-2 * distance * distance + 1e-15 + distance * 1e-3);
      ASSERT_GT(dot(q, a), 0.99);
    }
  }
}

TEST(Quaternion, RotatesLikeItsMatrix) {
  const double half = std::sqrt(0.5);
  const detail::Vec3d v = rotate({0, 0, half, half}, {1, 2, 3});
  EXPECT_NEAR(v.x, -2, 1e-15);
  EXPECT_NEAR(v.y, 1, 1e-15);
  EXPECT_NEAR(v.z, 3, 1e-15);
}

TEST(Quaternion, ZeroNormalisesToTheIdentity) {
  const Quaternion q = normalised({0, 0, 0, 0});
  EXPECT_EQ(q.w, 1);
  EXPECT_EQ(q.x, 0);
}

}  // namespace
}  // namespace pelt::asset
