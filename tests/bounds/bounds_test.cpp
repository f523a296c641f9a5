#include <pelt/bounds.hpp>

#include "bounds/box_of_triangles.hpp"
#include "support/animated_character.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

/// Checks bounds of one shape in one pose, at all levels, against the posed vertices.
struct Asked {
  Asked(const Shape& s, Pose& p) : shape(s), pose(p), positions(test::all_posed(p)) {
    exact = test::box_of(shape.triangles, positions);
  }

  void expect_encloses(const Bounds& found) const {
    EXPECT_TRUE(test::encloses(found.box, exact));
    EXPECT_TRUE(test::encloses(found.sphere, shape.triangles, positions));
  }

  void expect_good() {
    const Bounds widest = test::bounds_of(pose);
    expect_encloses(widest);
    for (const std::uint32_t levels : {1u, 2u, 3u, 200u}) {
      const Bounds found = test::bounds_of(pose, levels);
      expect_encloses(found);
      EXPECT_TRUE(test::encloses(widest.box, found.box));
    }
    const Bounds tight = test::exact_bounds_of(pose);
    EXPECT_TRUE(test::same_bits(tight.box, exact));
    EXPECT_TRUE(test::encloses(tight.sphere, shape.triangles, positions));
  }

  const Shape& shape;
  Pose& pose;
  std::vector<Vec3> positions;
  Box exact;
};

/// Joints with the largest scales that a palette may have.
TEST(Bounds, EncloseAtTheLimitsOfScale) {
  Random random(502);
  for (const float scale : {0x1p-100f, 0x1p-60f, 0x1p-20f, 0x1p20f, 0x1p50f})
    for (int round = 0; round < 10; ++round) {
      const Shape soup = test::make_soup(random, 100, 5, 4, Weights::random);
      Pose pose(*build_model(soup.view()));
      auto palette = test::make_palette(random, 5, Motion::affine, 1);
      for (Matrix4& joint : palette)
        for (std::size_t e = 0; e < 16; ++e)
          if (e % 4 != 3) joint.m[e] *= scale;
      ASSERT_TRUE(pose.set_palette(palette));
      Asked(soup, pose).expect_good();
    }
}

/// Half a turn between neighbouring joints: the surface between them collapses to a point.
TEST(Bounds, EncloseACandyWrapper) {
  const Shape limb = test::make_limb(60, 20, 2);
  Pose pose(*build_model(limb.view()));
  for (const double angle : {0.5, 2.0, 3.14159265358979}) {
    ASSERT_TRUE(pose.set_palette(
        std::vector<Matrix4>{test::rotation_about({0, 1, 0}, 0, {}, {1000, 0, 0}),
                             test::rotation_about({0, 1, 0}, angle, {}, {1000, 0, 0})}));
    Asked(limb, pose).expect_good();
  }
}

TEST(Bounds, VerticesThatNoTriangleUsesDoNotCount) {
  Shape limb = test::make_limb(12, 8, 3);
  limb.rest_positions.push_back({100, 100, 100});
  for (std::uint32_t i = 0; i < limb.influences_per_vertex; ++i) {
    limb.joints.push_back(0);
    limb.weights.push_back(i == 0 ? 1.0f : 0.0f);
  }
  Pose pose(*build_model(limb.view()));
  Asked(limb, pose).expect_good();
  EXPECT_LT(test::bounds_of(pose).box.high.x, 50);
  EXPECT_LT(test::bounds_of(pose).sphere.radius, 50);
}

TEST(Bounds, ZerosAreAlwaysPositive) {
  const Shape limb = test::make_limb(12, 8, 1);
  Pose pose(*build_model(limb.view()));
  Matrix4 flat;
  flat.m[0] = -0.0f, flat.m[5] = 0, flat.m[10] = -0.0f;
  ASSERT_TRUE(pose.set_palette(std::vector<Matrix4>{flat}));
  const Box point = test::exact_bounds_of(pose).box;
  EXPECT_TRUE(test::same_bits(point, Box{}));
}

TEST(Bounds, FromThePaletteAloneNothingIsPosedAndOneBoxComputed) {
  Random random(503);
  const Shape limb = test::make_limb(60, 20, 6);
  Pose pose(*build_model(limb.view()));
  ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 6, 0.5, {})));
  Bounds found;
  const QueryStats first = bounds(pose, found), again = bounds(pose, found);
  EXPECT_EQ(first.refits, 1u);
  EXPECT_EQ(first.posed_vertices, 0u);
  EXPECT_EQ(again.refits, 0u);
}

TEST(Bounds, TightOnesOpenAPartOfTheTreeOnceAndLevelsBoundTheWork) {
  Random random(504);
  const Shape limb = test::make_limb(400, 40, 8);
  Pose pose(*build_model(limb.view()));
  const auto palette = test::bend_limb(random, 8, 0.3, {});
  std::uint64_t posed = 0, visits = 0;
  Bounds found;
  for (const std::uint32_t levels : {1u, 2u, 3u, 4u}) {
    ASSERT_TRUE(pose.set_palette(palette));
    const QueryStats stats = bounds(pose, found, levels);
    EXPECT_GE(stats.posed_vertices, posed);
    EXPECT_GT(stats.node_pairs, visits);
    posed = stats.posed_vertices, visits = stats.node_pairs;
  }
  ASSERT_TRUE(pose.set_palette(palette));
  const QueryStats tight = exact_bounds(pose, found), again = exact_bounds(pose, found);
  EXPECT_GT(tight.posed_vertices, 0u);
  EXPECT_LT(tight.posed_vertices, limb.rest_positions.size() / 3);
  EXPECT_EQ(again.posed_vertices, 0u);
  EXPECT_EQ(again.refits, 0u);
}

TEST(FarthestVertex, OpensFewNodes) {
  Random random(941);
  const Shape limb = test::make_limb(200, 40, 5);
  Pose pose(*build_model(limb.view()));
  std::uint64_t posed = 0;
  for (int round = 0; round < 10; ++round) {
    ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 5, 0.4, random.point(1))));
    FarthestVertex found;
    posed += farthest_vertex(pose, random.point(1), found).posed_vertices;
  }
  EXPECT_GT(posed, 0u);
  EXPECT_LT(posed, 10 * limb.rest_positions.size() / 4);
}

TEST(FarthestVertex, AcceptsDirectionsOfAnyLength) {
  const Shape limb = test::make_limb(24, 10, 5);
  Pose pose(*build_model(limb.view()));
  FarthestVertex unit, tiny, huge;
  farthest_vertex(pose, {1, -2, 3}, unit);
  farthest_vertex(pose, {0x1p-149f, -0x1p-148f, 0x3p-149f}, tiny);
  farthest_vertex(pose, {0x1p125f, -0x1p126f, 0x3p125f}, huge);
  EXPECT_EQ(tiny.triangle, unit.triangle);
  EXPECT_EQ(huge.triangle, unit.triangle);
  EXPECT_EQ(tiny.corner, unit.corner);
  EXPECT_EQ(huge.corner, unit.corner);
}

// Bounds of real characters in all their clips.

/// The mean, over three axes, of the relative excess length of a box over the exact one.
double looseness(const Box& box, const Box& exact) {
  const auto ratio = [](float low, float high, float exact_low, float exact_high) {
    return static_cast<double>(high - low) / static_cast<double>(exact_high - exact_low);
  };
  return (ratio(box.low.x, box.high.x, exact.low.x, exact.high.x) +
          ratio(box.low.y, box.high.y, exact.low.y, exact.high.y) +
          ratio(box.low.z, box.high.z, exact.low.z, exact.high.z)) /
         3;
}

using SharedBounds = test::OfSharedModels<>;

TEST_P(SharedBounds, AreExactAndGuaranteedOnesAreClose) {
  const asset::Asset& asset = character->asset;
  Pose& pose = character->pose;
  const VertexGroups joints = group_by_joint(pose.model());
  for (const asset::Clip& clip : asset.clips) {
    constexpr int kFrames = 6;
    double loose = 0, loose_at_three = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      character->move(&clip, clip.duration * static_cast<float>(frame) / kFrames);
      const std::vector<Vec3> positions = test::all_posed(pose);
      const Box exact = test::box_of(asset.triangles, positions);
      const Bounds guaranteed = test::bounds_of(pose), three = test::bounds_of(pose, 3);
      EXPECT_TRUE(test::encloses(guaranteed.box, exact)) << clip.name;
      EXPECT_TRUE(test::encloses(guaranteed.sphere, asset.triangles, positions)) << clip.name;
      EXPECT_TRUE(test::encloses(three.box, exact)) << clip.name;
      EXPECT_TRUE(test::same_bits(test::exact_bounds_of(pose).box, exact)) << clip.name;
      for (std::uint32_t j = 0; j < joints.count(); ++j)
        EXPECT_TRUE(test::encloses(test::group_box(pose, joints, j),
                                   test::exact_group_box(pose, joints, j)));
      loose += looseness(guaranteed.box, exact) / kFrames;
      loose_at_three += looseness(three.box, exact) / kFrames;
    }
    EXPECT_LE(loose_at_three, loose) << clip.name;
    if (GetParam() == std::string("human.glb")) {
      EXPECT_LT(loose, 1.25) << clip.name;
      EXPECT_LT(loose_at_three, 1.15) << clip.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SharedBounds,
                         testing::Values("human.glb", "human_8inf.glb", "knight.glb",
                                         "fox_khronos.glb", "frog.glb", "cesium_man.glb"));

}  // namespace
}  // namespace pelt
