#include "paper/weight_bounds.hpp"

#include "paper/on_demand.hpp"
#include "posed_mesh.hpp"

#include <gtest/gtest.h>

#include <set>

namespace pelt::paper {
namespace {

using test::Random;
using test::Weights;

constexpr std::uint32_t kJoints = 14;

using Joints = std::vector<std::uint16_t>;

Joints joints_of(const SkinnedMesh& mesh, std::uint32_t vertex) {
  Joints joints;
  for (const detail::Influence& influence : mesh.influences_of(vertex))
    joints.push_back(static_cast<std::uint16_t>(influence.joint));
  return joints;
}

Joints joints_of(const WeightBounds& bounds, const JointSet& set) {
  const auto first = bounds.joints.begin() + set.first_joint;
  return {first, first + set.joint_count};
}

/// Calls `check(mesh, tree, bounds, node)` for all nodes of soups with all kinds of weights.
template <typename Check>
void for_each_node(BoundKind kind, Check check) {
  Random random(1);
  for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
    for (const std::uint32_t influences : {1, 2, 4, 8, 12}) {
      const SkinnedMesh mesh =
          test::checked_mesh(make_soup(random, 60, kJoints, influences, weights));
      const SphereModel model = build_sphere_model(mesh, kind);
      for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
        check(mesh, model.tree, model.bounds, n);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
}

TEST(WeightBounds, HaveEachJointSetOfANodesVerticesOnce) {
  for_each_node(BoundKind::optimised, [](const SkinnedMesh& mesh, const SphereTree& tree,
                                         const WeightBounds& bounds, std::uint32_t n) {
    std::set<Joints> expected, found;
    for (const std::uint32_t v : test::vertices_below(mesh, tree, tree.nodes[n]))
      expected.insert(joints_of(mesh, v));
    for (const JointSet& set : bounds.sets_of(n)) found.insert(joints_of(bounds, set));
    ASSERT_EQ(found, expected);
    ASSERT_EQ(bounds.sets_of(n).size(), expected.size());
  });
}

TEST(WeightBounds, CornersSpanTheWeightsOfTheVertices) {
  Random random(2);
  for_each_node(BoundKind::optimised, [&](const SkinnedMesh& mesh, const SphereTree& tree,
                                          const WeightBounds& bounds, std::uint32_t n) {
    for (const std::uint32_t v : test::vertices_below(mesh, tree, tree.nodes[n]))
      for (const JointSet& set : bounds.sets_of(n)) {
        if (joints_of(bounds, set) != joints_of(mesh, v)) continue;
        std::vector<double> q(set.joint_count);
        for (double& entry : q) entry = random.uniform(-1, 1);
        double weight_sum = 0, value = 0, largest = -1e9;
        for (std::size_t j = 0; j < q.size(); ++j) {
          weight_sum += static_cast<double>(mesh.influences_of(v)[j].weight);
          value += static_cast<double>(mesh.influences_of(v)[j].weight) * q[j];
        }
        for (std::uint32_t a = 0; a < set.corner_count; ++a) {
          double at_corner = 0;
          for (std::size_t j = 0; j < q.size(); ++j)
            at_corner +=
                static_cast<double>(bounds.corners[set.first_corner + a * set.joint_count + j]) *
                q[j];
          largest = std::max(largest, at_corner);
        }
        ASSERT_LE(value / weight_sum, largest + 1e-6);
      }
  });
}

TEST(WeightBounds, ATriangleWhoseVerticesShareNoJointHasThreeSets) {
  test::Shape shape;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}};
  shape.influences_per_vertex = 2;
  shape.joints = {0, 1, 2, 3, 4, 5};
  shape.weights = {0.25f, 0.75f, 0.5f, 0.5f, 1, 0};
  shape.joint_count = 6;
  const SphereModel model = build_sphere_model(test::checked_mesh(shape));
  const WeightBounds& bounds = model.bounds;
  ASSERT_EQ(bounds.sets_of(0).size(), 3u);
  EXPECT_EQ(joints_of(bounds, bounds.sets_of(0)[0]), (Joints{0, 1}));
  EXPECT_EQ(joints_of(bounds, bounds.sets_of(0)[1]), (Joints{2, 3}));
  EXPECT_EQ(joints_of(bounds, bounds.sets_of(0)[2]), (Joints{4}));
  EXPECT_EQ(bounds.corners, (std::vector<float>{1, 0.25f, 0.75f, 0.5f, 0.5f, 1}))
      << "the first stands for all joints that are alone";
}

TEST(WeightBounds, ManyJointsHaveAsManyCorners) {
  int large_sets = 0;
  for_each_node(BoundKind::optimised, [&](const SkinnedMesh&, const SphereTree&,
                                          const WeightBounds& bounds, std::uint32_t n) {
    for (const JointSet& set : bounds.sets_of(n)) {
      if (set.joint_count <= 8) continue;
      ASSERT_EQ(set.corner_count, set.joint_count);
      ++large_sets;
    }
  });
  EXPECT_GT(large_sets, 50);
}

TEST(WeightBounds, PlainOnesHaveEachJointOnceWithWeightOne) {
  for_each_node(BoundKind::plain, [](const SkinnedMesh& mesh, const SphereTree& tree,
                                     const WeightBounds& bounds, std::uint32_t n) {
    std::set<std::uint16_t> expected, found;
    for (const std::uint32_t v : test::vertices_below(mesh, tree, tree.nodes[n]))
      for (const std::uint16_t joint : joints_of(mesh, v)) expected.insert(joint);
    for (const JointSet& set : bounds.sets_of(n)) {
      ASSERT_EQ(set.joint_count, 1);
      ASSERT_EQ(set.corner_count, 1);
      ASSERT_EQ(bounds.corners[set.first_corner], 1);
      found.insert(bounds.joints[set.first_joint]);
    }
    ASSERT_EQ(found, expected);
    ASSERT_EQ(bounds.sets_of(n).size(), expected.size());
  });
}

TEST(WeightBounds, WhatIsMadeToTakeMemoryGetsThePlainBound) {
  Random random(4);
  const test::Shape shape = test::make_soup(random, 300, 600, 512, test::Weights::random);
  BuildReport report;
  const SkinnedMesh mesh = *detail::make_skinned_mesh(shape.view(), {}, report);
  const SphereTree tree = build_sphere_tree(mesh.rest_positions, mesh.triangles);
  const WeightBounds bounds = build_weight_bounds(mesh, tree, BoundKind::optimised);
  EXPECT_LT(bounds.corners.size(), 5u << 20) << "all corners would be 100 times as many";
  EXPECT_GT(bounds.corners.size(), 1u << 20) << "the memory there is is used";
  const auto last = static_cast<std::uint32_t>(tree.nodes.size() - 1);
  for (const JointSet& set : bounds.sets_of(last)) EXPECT_EQ(set.joint_count, 1u);
}

}  // namespace
}  // namespace pelt::paper
