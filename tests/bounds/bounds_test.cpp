#include <pelt/bounds.hpp>

#include "bounds/box_of_triangles.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
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

TEST(Bounds, EncloseAndTightOnesAreExactOnBendingLimbs) {
  Random random(500);
  const Shape limb = test::make_limb(60, 20, 6);
  Pose pose(*build_model(limb.view()));
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    ASSERT_TRUE(
        pose.set_palette(test::bend_limb(random, 6, random.uniform(-1.5, 1.5), random.point(2))));
    Asked(limb, pose).expect_good();
  }
}

TEST(Bounds, EncloseSoupsUnderAnyAffineJointsOnEachTarget) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(501);
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
        for (const std::uint32_t influences : {1u, 3u, 9u}) {
          const Shape soup = test::make_soup(random, 300, 12, influences, weights);
          Pose pose(*build_model(soup.view()));
          ASSERT_TRUE(pose.set_palette(test::make_palette(random, 12, motion, 1)));
          Asked(soup, pose).expect_good();
        }
  });
}

TEST(Bounds, EncloseWhatMorphTargetsDisplaceOnEachTarget) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(507);
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::far_away})
      for (const test::Morphing morphing : test::kAllMorphings) {
        Shape soup = test::make_soup(random, 300, 12, 4, Weights::random);
        test::add_morph_targets(random, soup, 14, 0.2, 0.5);
        Pose pose(*build_model(soup.view()));
        ASSERT_TRUE(pose.set_palette(test::make_palette(random, 12, motion, 1)));
        ASSERT_TRUE(pose.set_morph_weights(test::make_morph_weights(random, 14, morphing)));
        Asked(soup, pose).expect_good();
      }
  });
}

TEST(Bounds, AreTheSameAfterTheSameWorkOnEachTarget) {
  Random random(506);
  const Shape limb = test::make_limb(60, 20, 6);
  Pose pose(*build_model(limb.view()));
  for (int round = 0; round < 20; ++round) {
    const auto palette = test::bend_limb(random, 6, 0.8, random.point(10));
    for (const std::uint32_t levels : {0u, 1u, 2u, 100u}) {
      std::vector<Bounds> found;
      std::vector<QueryStats> work;
      test::on_each_instruction_set([&](InstructionSet) {
        ASSERT_TRUE(pose.set_palette(palette));
        work.push_back(bounds(pose, found.emplace_back(), levels));
      });
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_TRUE(test::same_bits(found[i].box, found[0].box));
        EXPECT_TRUE(test::same_bits(found[i].sphere.centre, found[0].sphere.centre));
        EXPECT_EQ(found[i].sphere.radius, found[0].sphere.radius);
        EXPECT_EQ(work[i].node_pairs, work[0].node_pairs);
        EXPECT_EQ(work[i].posed_vertices, work[0].posed_vertices);
      }
    }
  }
}

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

TEST(Bounds, DoNotAllocateOnceThePoseIsReserved) {
  Random random(505);
  const Shape limb = test::make_limb(60, 20, 6);
  Pose pose(*build_model(limb.view()));
  pose.reserve();
  const auto palette = test::bend_limb(random, 6, 0.7, {});
  const std::size_t before = test::allocation_count();
  for (const std::uint32_t levels : {0u, 1u, 2u, 100u}) {
    ASSERT_TRUE(pose.set_palette(palette));
    test::bounds_of(pose, levels);
  }
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_GT(test::allocation_count(), 0u) << "the counter must count";
}

}  // namespace
}  // namespace pelt
