#include <pelt/bounds.hpp>

#include "bounds/box_of_triangles.hpp"
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

/// Labels in long runs, like the parts of a file; some triangles belong to no group.
std::vector<std::uint32_t> random_labels(Random& random, std::size_t triangles,
                                         std::uint32_t groups) {
  std::vector<std::uint32_t> labels(triangles);
  std::uint32_t label = 0;
  for (std::uint32_t& l : labels) {
    if (random.chance(0.1)) label = random.chance(0.2) ? kNoGroup : random.index(groups);
    l = label;
  }
  return labels;
}

std::vector<Triangle> labelled(const Shape& shape, const std::vector<std::uint32_t>& labels,
                               std::uint32_t label) {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < labels.size(); ++t)
    if (labels[t] == label) triangles.push_back(shape.triangles[t]);
  return triangles;
}

TEST(VertexGroups, OfTrianglesAreEnclosedAndExact) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(510);
    int empty = 0;
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial}) {
        Shape soup = test::make_soup(random, 200, 9, 4, weights);
        test::add_morph_targets(random, soup, 8, 0.3, 0.5);
        const auto labels = random_labels(random, soup.triangles.size(), 30);
        Pose pose(*build_model(soup.view()));
        const Result<VertexGroups> groups = group_triangles(pose.model(), labels);
        ASSERT_TRUE(groups);
        ASSERT_TRUE(pose.set_palette(test::make_palette(random, 9, motion, 1)));
        const auto morphing = test::kAllMorphings[random.index(6)];
        ASSERT_TRUE(pose.set_morph_weights(test::make_morph_weights(random, 8, morphing)));
        const std::vector<Vec3> positions = test::all_posed(pose);
        for (std::uint32_t g = 0; g < groups->count(); ++g) {
          const Box exact = test::box_of(labelled(soup, labels, g), positions);
          EXPECT_TRUE(test::same_bits(test::exact_group_box(pose, *groups, g), exact));
          EXPECT_TRUE(test::encloses(test::group_box(pose, *groups, g), exact));
          if (groups->vertex_count(g) > 0) continue;
          EXPECT_TRUE(test::same_bits(test::group_box(pose, *groups, g), test::nothing()));
          ++empty;
        }
      }
    EXPECT_GT(empty, 0);
  });
}

/// The joint with the largest weight of a vertex.
std::uint32_t leading_joint(const Shape& shape, std::uint32_t vertex) {
  const std::size_t row = std::size_t{vertex} * shape.influences_per_vertex;
  std::vector<double> weights(shape.joint_count);
  for (std::size_t i = row; i < row + shape.influences_per_vertex; ++i)
    weights[shape.joints[i]] += static_cast<double>(shape.weights[i]);
  return static_cast<std::uint32_t>(std::max_element(weights.begin(), weights.end()) -
                                    weights.begin());
}

TEST(VertexGroups, OfJointsHaveTheVerticesThatFollowThemMost) {
  Random random(511);
  const Shape limb = test::make_limb(40, 12, 5);
  Pose pose(*build_model(limb.view()));
  const VertexGroups groups = group_by_joint(pose.model());
  ASSERT_EQ(groups.count(), 5u);
  for (int round = 0; round < 20; ++round) {
    ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 5, 0.6, random.point(1))));
    const std::vector<Vec3> positions = test::all_posed(pose);
    Box all = test::nothing();
    for (std::uint32_t joint = 0; joint < 5; ++joint) {
      Box expected = test::nothing();
      for (std::uint32_t v = 0; v < positions.size(); ++v)
        if (leading_joint(limb, v) == joint) test::include(positions[v], expected);
      const Box exact = test::exact_group_box(pose, groups, joint);
      EXPECT_TRUE(test::same_bits(exact, expected));
      EXPECT_TRUE(test::encloses(test::group_box(pose, groups, joint), exact));
      test::include(exact.low, all);
      test::include(exact.high, all);
    }
    EXPECT_TRUE(test::same_bits(all, test::exact_bounds_of(pose).box));
  }
}

TEST(VertexGroups, AVertexCountsOnceAndOnesThatNoTriangleUsesNever) {
  const Shape limb = test::make_limb(200, 20, 4);
  const SkinnedModel model = *build_model(limb.view());
  const std::vector<std::uint32_t> labels(limb.triangles.size(), 0);
  const VertexGroups groups = *group_triangles(model, labels);
  EXPECT_EQ(groups.vertex_count(0), limb.rest_positions.size());
  EXPECT_GT(groups.memory_bytes(), 4 * limb.rest_positions.size());
}

TEST(VertexGroups, RefuseLabelsThatAreNotThatOfEachTriangle) {
  const Shape limb = test::make_limb(12, 8, 3);
  const SkinnedModel model = *build_model(limb.view());
  std::vector<std::uint32_t> labels(limb.triangles.size() + 1, 0);
  const Result<VertexGroups> too_many = group_triangles(model, labels);
  ASSERT_FALSE(too_many);
  EXPECT_NE(too_many.error().message.find("labels has"), std::string::npos);
  labels.pop_back();
  labels[5] = static_cast<std::uint32_t>(labels.size());
  const Result<VertexGroups> too_large = group_triangles(model, labels);
  ASSERT_FALSE(too_large);
  EXPECT_NE(too_large.error().message.find("labels[5] is"), std::string::npos);
  labels.assign(labels.size(), kNoGroup);
  const Result<VertexGroups> none = group_triangles(model, labels);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->count(), 0u);
}

TEST(VertexGroups, CountEachDisplacementByActiveTargets) {
  const Shape limb = test::make_morphing_limb(12, 8, 3);
  Pose pose(*build_model(limb.view()));
  const std::vector<std::uint32_t> labels(limb.triangles.size(), 0);
  const VertexGroups groups = *group_triangles(pose.model(), labels);
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{0.5f, 0, 1}));
  const auto displaced_by = [&](std::size_t m) {
    return limb.morph_begin[m + 1] - limb.morph_begin[m];
  };
  Box box;
  const QueryStats stats = exact_group_bounds(pose, groups, 0, box);
  EXPECT_EQ(stats.posed_vertices, limb.rest_positions.size());
  EXPECT_EQ(stats.displacements, displaced_by(0) + displaced_by(2));
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{0, 0, 0}));
  EXPECT_EQ(exact_group_bounds(pose, groups, 0, box).displacements, 0u);
}

}  // namespace
}  // namespace pelt
