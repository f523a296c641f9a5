#include "skin/palette.hpp"

#include <pelt/crowd.hpp>

#include "pose/pose.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt {
namespace {

using test::Random;

Pose make_pose() { return Pose(*build_model(test::make_limb(8, 6, 3).view())); }

std::string refusal(Pose& pose, const std::vector<Matrix4>& palette) {
  const Result<void> taken = pose.set_palette(palette);
  return taken ? "accepted" : taken.error().message;
}

TEST(SetPalette, RefusesWithTheElementAndLeavesThePoseAsItWas) {
  Pose pose = make_pose();
  Random random(3);
  const auto good = test::make_palette(random, 3, test::Motion::affine, 2);
  ASSERT_TRUE(pose.set_palette(good));
  std::vector<Vec3> before(pose.model().vertex_count()), after(before.size());
  posed_vertices(pose, before);

  const auto refuse = [&](std::size_t joint, std::size_t element, float value) {
    auto bad = test::make_palette(random, 3, test::Motion::rigid, 1);
    bad[joint].m[element] = value;
    return refusal(pose, bad);
  };
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refuse(1, 9, std::numeric_limits<float>::quiet_NaN()),
            "palette[1] has the element nan at row 1, column 2");
  EXPECT_EQ(refuse(2, 12, -infinity), "palette[2] has the element -inf at row 0, column 3");
  EXPECT_EQ(refuse(0, 3, 0.5f),
            "palette[0] has the last row 0.5 0 0 1, expected 0 0 0 1 (is the matrix row-major?)");
  EXPECT_EQ(refuse(2, 15, std::numeric_limits<float>::quiet_NaN()),
            "palette[2] has the element nan at row 3, column 3");
  EXPECT_EQ(refuse(2, 13, 0x1p61f), "palette[2] can move a vertex beyond 2^60 units");
  EXPECT_EQ(refuse(2, 5, std::numeric_limits<float>::max()),
            "palette[2] can move a vertex beyond 2^60 units");

  EXPECT_EQ(refusal(pose, test::make_palette(random, 2, test::Motion::rigid, 1)),
            "the palette has 32 floats, expected 48: 16 for each of the model's 3 joints");
  EXPECT_EQ(refusal(pose, {}),
            "the palette has 0 floats, expected 48: 16 for each of the model's 3 joints");

  posed_vertices(pose, after);
  EXPECT_EQ(before, after);
}

TEST(SetPalette, FindsEveryElementThatIsNotFiniteWhateverStandsBesideIt) {
  Pose pose = make_pose();
  Random random(6);
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity})
    for (std::size_t joint = 0; joint < 3; ++joint)
      for (std::size_t element = 0; element < 16; ++element) {
        auto bad = test::make_palette(random, 3, test::Motion::affine, 1e6);
        bad[joint].m[element] = value;
        const std::string expected = "palette[" + std::to_string(joint) + "] has the element ";
        const std::string row_and_column =
            " at row " + std::to_string(element % 4) + ", column " + std::to_string(element / 4);
        const std::string message = refusal(pose, bad);
        EXPECT_EQ(message.find(expected), 0u) << message;
        EXPECT_NE(message.find(row_and_column), std::string::npos) << message;
      }
}

TEST(SetPalette, FindsEveryLastRowThatIsNot0001) {
  Pose pose = make_pose();
  Random random(7);
  for (std::size_t joint = 0; joint < 3; ++joint)
    for (const std::size_t element : {3u, 7u, 11u, 15u})
      for (const float value : {-1.0f, std::nextafter(1.0f, 0.0f), 1e-45f, -1e-45f, 1e30f, 3e38f}) {
        auto bad = test::make_palette(random, 3, test::Motion::rigid, 1);
        bad[joint].m[element] = value;
        EXPECT_EQ(
            refusal(pose, bad).find("palette[" + std::to_string(joint) + "] has the last row"), 0u);
      }
  auto good = test::make_palette(random, 3, test::Motion::rigid, 1);
  for (const std::size_t element : {3u, 7u, 11u}) good[1].m[element] = -0.0f;
  EXPECT_EQ(refusal(pose, good), "accepted");
}

TEST(SetPalette, RefusesFiniteElementsWhoseSumsOverflow) {
  Pose pose = make_pose();
  const float largest = std::numeric_limits<float>::max();
  for (std::size_t joint = 0; joint < 3; ++joint)
    for (const std::size_t row : {0u, 1u, 2u}) {
      std::vector<Matrix4> bad(3);
      for (const std::size_t column : {0u, 4u, 8u, 12u}) bad[joint].m[column + row] = -largest;
      EXPECT_EQ(refusal(pose, bad),
                "palette[" + std::to_string(joint) + "] can move a vertex beyond 2^60 units");
    }
}

TEST(SetPalette, NamesTheFirstJointThatIsBad) {
  Pose pose = make_pose();
  std::vector<Matrix4> bad(3);
  bad[2].m[0] = std::numeric_limits<float>::quiet_NaN();
  bad[1].m[3] = 1;
  EXPECT_EQ(refusal(pose, bad).find("palette[1] has the last row 1 0 0 1"), 0u);
}

/// One joint's linear part and another's translation are both near the limit. No vertex exceeds the
/// limit, although the extent of all joints together does.
TEST(SetPalette, MeasuresJointByJointWhatTheyCanDo) {
  Pose pose = make_pose();
  std::vector<Matrix4> palette(3);
  palette[0].m[0] = 0x1p59f;
  palette[2].m[12] = 0x1.8p59f;
  ASSERT_EQ(refusal(pose, palette), "accepted");
  std::vector<Vec3> posed(pose.model().vertex_count());
  posed_vertices(pose, posed);
  for (const Vec3& v : posed) EXPECT_LE(std::fabs(v.x), 0x1p60f);
  palette[0].m[12] = 0x1.8p59f;
  EXPECT_EQ(refusal(pose, palette), "palette[0] can move a vertex beyond 2^60 units");
}

TEST(Palette, ExtentIsThatOfTheLargestElements) {
  Random random(8);
  for (const std::uint32_t joints : {1u, 2u, 7u, 130u})
    for (int round = 0; round < 20; ++round) {
      const auto matrices = test::make_palette(random, joints, test::Motion::affine, 10);
      double linear = 0, translation = 0;
      for (const Matrix4& joint : matrices)
        for (std::size_t e = 0; e < 16; ++e) {
          double& largest = e < 12 ? linear : translation;
          if (e % 4 != 3) largest = std::max(largest, std::fabs(static_cast<double>(joint.m[e])));
        }
      detail::Palette palette(joints, 3);
      ASSERT_TRUE(palette.set(matrices));
      const double extent = linear * 3 + translation;
      EXPECT_GT(static_cast<double>(palette.extent()), extent);
      EXPECT_LT(static_cast<double>(palette.extent()), extent * (1 + 0x1p-22));
    }
}

TEST(Palette, ExtentIsFarAboveWhatUnderflows) {
  detail::Palette palette(1, 0x1p60f);
  Matrix4 joint;
  joint.m = {};
  joint.m[15] = 1;
  ASSERT_TRUE(palette.set(joint.m));
  EXPECT_GE(palette.extent(), 0x1p-40f) << "linear parts count as 2^-100 at least";
}

TEST(SetPalette, NoBlendOverflowsHoweverSmallTheMesh) {
  test::Shape speck = test::make_limb(8, 6, 3);
  for (Vec3& p : speck.rest_positions) p = {0x1p-90f * p.x, 0x1p-90f * p.y, 0x1p-90f * p.z};
  Pose pose(*build_model(speck.view()));
  std::vector<Matrix4> palette(3);
  for (Matrix4& joint : palette) joint.m[0] = std::numeric_limits<float>::max();
  EXPECT_EQ(refusal(pose, palette), "palette[0] can move a vertex beyond 2^60 units");
  for (Matrix4& joint : palette) joint.m[0] = 0x1p119f;
  ASSERT_EQ(refusal(pose, palette), "accepted");
  std::vector<Vec3> posed(speck.rest_positions.size());
  posed_vertices(pose, posed);
  for (const Vec3& v : posed) EXPECT_TRUE(std::isfinite(v.x));
}

TEST(SetPalette, TakesEngineArraysAsTheyAre) {
  Pose by_matrices = make_pose(), by_floats = make_pose();
  Random random(4);
  const auto palette = test::make_palette(random, 3, test::Motion::affine, 2);
  std::vector<float> floats;
  for (const Matrix4& joint : palette) floats.insert(floats.end(), joint.m.begin(), joint.m.end());
  ASSERT_TRUE(by_matrices.set_palette(palette));
  ASSERT_TRUE(by_floats.set_palette(floats));
  std::vector<Vec3> a(by_matrices.model().vertex_count()), b(a.size());
  posed_vertices(by_matrices, a);
  posed_vertices(by_floats, b);
  EXPECT_EQ(a, b);
}

TEST(Pose, StartsInTheRestPose) {
  const test::Shape limb = test::make_limb(8, 6, 3);
  const Pose pose(*build_model(limb.view()));
  std::vector<Vec3> posed(limb.rest_positions.size());
  posed_vertices(pose, posed);
  for (std::size_t v = 0; v < posed.size(); ++v) {
    EXPECT_NEAR(posed[v].x, limb.rest_positions[v].x, 1e-6);
    EXPECT_NEAR(posed[v].y, limb.rest_positions[v].y, 1e-6);
    EXPECT_NEAR(posed[v].z, limb.rest_positions[v].z, 1e-6);
  }
}

TEST(Palette, NoVertexIsPosedBeyondItsReach) {
  Random random(5);
  for (const test::Motion motion : {test::Motion::rigid, test::Motion::affine,
                                    test::Motion::collapsed, test::Motion::far_away}) {
    const test::Shape soup = test::make_soup(random, 200, 6, 4, test::Weights::adversarial);
    Pose pose(*build_model(soup.view()));
    ASSERT_TRUE(pose.set_palette(test::make_palette(random, 6, motion, 3)));
    std::vector<Vec3> posed(soup.rest_positions.size());
    posed_vertices(pose, posed);
    const double reach = pose.detail().palette.reach();
    double farthest = 0;
    for (const Vec3& v : posed)
      farthest = std::max(farthest, std::hypot(static_cast<double>(v.x), static_cast<double>(v.y),
                                               static_cast<double>(v.z)));
    EXPECT_LE(farthest, reach * (1 + 1e-6));
    EXPECT_GE(farthest, reach * 0.1) << "not a bound to be proud of";
  }
}

std::vector<Matrix3x4> rows_of(const std::vector<Matrix4>& palette) {
  std::vector<Matrix3x4> rows(palette.size());
  for (std::size_t j = 0; j < palette.size(); ++j)
    for (std::size_t i = 0; i < 12; ++i) rows[j].m[i] = palette[j].m[4 * (i % 4) + i / 4];
  return rows;
}

/// Doubles that round to the palette, some up and some down.
std::vector<double> doubles_of(const std::vector<Matrix4>& palette) {
  std::vector<double> doubles;
  for (const Matrix4& matrix : palette)
    for (std::size_t i = 0; i < 16; ++i)
      doubles.push_back(double{matrix.m[i]} * (i % 2 ? 1 + 0x1p-30 : 1 - 0x1p-30));
  return doubles;
}

TEST(SetPalette, OfThreeRowsAndOfDoublesPosesAsTheSameFloatsDo) {
  Random random(8);
  Pose pose = make_pose(), rows = make_pose(), doubles = make_pose();
  Crowd crowd;
  for (int i = 0; i < 3; ++i) crowd.add(pose.model());
  for (const test::Motion motion : {test::Motion::rigid, test::Motion::affine}) {
    const auto palette = test::make_palette(random, 3, motion, 2);
    ASSERT_TRUE(pose.set_palette(palette) && crowd.set_palette(0, palette));
    ASSERT_TRUE(rows.set_palette(rows_of(palette)) && crowd.set_palette(1, rows_of(palette)));
    ASSERT_TRUE(doubles.set_palette(doubles_of(palette)) &&
                crowd.set_palette(2, doubles_of(palette)));
    const auto expected = pose.detail().palette.joints();
    EXPECT_TRUE(std::ranges::equal(rows.detail().palette.joints(), expected));
    EXPECT_TRUE(std::ranges::equal(doubles.detail().palette.joints(), expected));
    EXPECT_EQ(rows.detail().palette.extent(), pose.detail().palette.extent());
    EXPECT_EQ(doubles.detail().palette.extent(), pose.detail().palette.extent());
    std::vector<CrowdPair> pairs;
    crowd.intersecting_pairs(pairs);
    EXPECT_EQ(pairs.size(), 3u) << "all three stand in one place";
  }
}

TEST(SetPalette, OfThreeRowsAndOfDoublesRefusesWithTheElement) {
  Random random(9);
  Pose pose = make_pose();
  const auto good = test::make_palette(random, 3, test::Motion::rigid, 2);
  ASSERT_TRUE(pose.set_palette(good));
  auto rows = rows_of(good);
  rows[1].m[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(pose.set_palette(rows).error().message,
            "palette[1] has the element nan at row 1, column 3");
  rows.pop_back();
  EXPECT_EQ(pose.set_palette(rows).error().message,
            "the palette has 2 matrices, expected 3: one for each joint");
  auto doubles = doubles_of(good);
  doubles[32 + 12] = -1e300;
  EXPECT_EQ(pose.set_palette(doubles).error().message,
            "palette[2] has the element -inf at row 0, column 3");
  doubles.pop_back();
  EXPECT_EQ(pose.set_palette(doubles).error().message,
            "the palette has 47 doubles, expected 48: 16 for each of the model's 3 joints");
  EXPECT_TRUE(std::ranges::equal(pose.detail().palette.joints(), good)) << "left as it was";
}

}  // namespace
}  // namespace pelt
