#include "paper/sphere_tree.hpp"

#include "paper/on_demand.hpp"
#include "posed_mesh.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace pelt::paper {
namespace {

using test::Random;
using test::Shape;
using test::Weights;

Shape make_shape(Random& random, int i) {
  return i % 2 == 0 ? test::make_limb(4 + random.index(12), 3 + random.index(8), 3)
                    : make_soup(random, 1 + random.index(200), 3, 2, Weights::random);
}

SphereTree binary_tree(const Shape& shape) {
  return build_binary_tree(shape.rest_positions, shape.triangles);
}

/// Uses rational arithmetic.
bool encloses(const Sphere& sphere, const Vec3& v) {
  const auto squared_difference = [](float a, float b) -> mpq_class {
    const mpq_class d = mpq_class(static_cast<double>(a)) - mpq_class(static_cast<double>(b));
    return d * d;
  };
  const mpq_class radius(static_cast<double>(sphere.radius));
  return squared_difference(v.x, sphere.centre.x) + squared_difference(v.y, sphere.centre.y) +
             squared_difference(v.z, sphere.centre.z) <=
         radius * radius;
}

/// The invariants of both passes.
void expect_well_formed(const SphereTree& tree, const Shape& shape) {
  std::vector<std::uint32_t> parents(tree.nodes.size(), 0);
  std::set<std::uint32_t> leaf_triangles;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    std::uint32_t at = node.first_triangle;
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
      ASSERT_GT(c, n);
      ++parents[c];
      ASSERT_EQ(tree.nodes[c].first_triangle, at);  // the children partition the triangles
      at += tree.nodes[c].triangle_count;
    }
    if (node.is_leaf()) {
      ASSERT_EQ(node.triangle_count, 1u);
      leaf_triangles.insert(tree.triangle_of_leaf(node));
    } else {
      ASSERT_GE(node.child_count, 2u);
      ASSERT_EQ(at, node.first_triangle + node.triangle_count);
    }
    for (const std::uint32_t t : tree.triangles_of(node))
      for (const std::uint32_t v : shape.triangles[t])
        ASSERT_TRUE(encloses(node.rest, shape.rest_positions[v]));
  }
  ASSERT_EQ(tree.nodes[0].triangle_count, shape.triangles.size());
  ASSERT_EQ(leaf_triangles.size(), shape.triangles.size());
  for (std::uint32_t n = 1; n < tree.nodes.size(); ++n) ASSERT_EQ(parents[n], 1u);
}

TEST(BinaryTree, HasOneTriangleInALeafAndEnclosesItsVerticesExactly) {
  Random random(1);
  for (int i = 0; i < 12; ++i) {
    const Shape shape = make_shape(random, i);
    const SphereTree tree = binary_tree(shape);
    ASSERT_EQ(tree.nodes.size(), 2 * shape.triangles.size() - 1);
    ASSERT_NO_FATAL_FAILURE(expect_well_formed(tree, shape));
  }
}

TEST(BinaryTree, OfOneTriangleIsALeaf) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const SphereTree tree = build_sphere_tree(positions, triangles);
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_TRUE(tree.nodes[0].is_leaf());
  EXPECT_NEAR(tree.nodes[0].rest.radius, std::sqrt(0.5), 1e-6);
  EXPECT_EQ(level_statistics(tree).size(), 1u);
}

TEST(BinaryTree, HalvesTrianglesWhoseCentroidsAllLieInOnePlace) {
  Shape shape;
  for (std::uint32_t t = 0; t < 100; ++t) {
    const float s = 1 + static_cast<float>(t);
    shape.rest_positions.insert(shape.rest_positions.end(), {{s, 0, 0}, {-s, s, 0}, {0, -s, 0}});
    shape.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const SphereTree tree = binary_tree(shape);
  ASSERT_NO_FATAL_FAILURE(expect_well_formed(tree, shape));
  EXPECT_EQ(level_statistics(tree).size(), 8u);  // 2^6 < 100 <= 2^7
}

/// Identifies a node of the binary tree by the range of its triangles, which is unique.
using Range = std::pair<std::uint32_t, std::uint32_t>;

Range range_of(const Node& node) { return {node.first_triangle, node.triangle_count}; }

/// Checks the rule of section 3.1 in both directions, for the nodes below `n` of the binary tree
/// whose surviving parent is the node `parent`: deleted if and only if c_r > ratio p_r.
void expect_rule_kept(const SphereTree& binary, const std::map<Range, const Node*>& survivors,
                      std::uint32_t n, const Node& parent, float ratio) {
  for (std::uint32_t c = binary.nodes[n].first_child; c < binary.nodes[n].first_child + 2; ++c) {
    const Node& child = binary.nodes[c];
    const auto survivor = survivors.find(range_of(child));
    const bool deleted = survivor == survivors.end();
    ASSERT_EQ(deleted, !child.is_leaf() && child.rest.radius > ratio * parent.rest.radius);
    const Node& kept = deleted ? parent : *survivor->second;
    if (!deleted) {
      ASSERT_EQ(kept.rest.radius, child.rest.radius);
    }
    if (!child.is_leaf()) expect_rule_kept(binary, survivors, c, kept, ratio);
  }
}

TEST(Collapse, DeletesExactlyTheInnerNodesThatAreNearlyAsLargeAsTheirSurvivingParent) {
  Random random(2);
  std::size_t deleted = 0, kept = 0;
  for (int i = 0; i < 12; ++i) {
    const Shape shape = make_shape(random, i);
    const SphereTree binary = binary_tree(shape);
    for (const float ratio : {0.3f, kCollapseRatio, 0.9f}) {
      const SphereTree tree = collapse(binary, ratio);
      ASSERT_NO_FATAL_FAILURE(expect_well_formed(tree, shape));
      std::map<Range, const Node*> survivors;
      for (const Node& node : tree.nodes) survivors.emplace(range_of(node), &node);
      ASSERT_EQ(survivors.size(), tree.nodes.size());
      if (binary.nodes.size() > 1) expect_rule_kept(binary, survivors, 0, tree.nodes[0], ratio);
      deleted += binary.nodes.size() - tree.nodes.size();
      kept += tree.nodes.size() - shape.triangles.size();
    }
  }
  EXPECT_GT(deleted, 1000u);
  EXPECT_GT(kept, 1000u);
}

TEST(Collapse, KeepsTheBinaryTreeUnderALargeRatioAndOnlyLeavesUnderNone) {
  const Shape shape = test::make_limb(10, 8, 3);
  const SphereTree binary = binary_tree(shape);
  const SphereTree same = collapse(binary, 1e9f);
  ASSERT_EQ(same.nodes.size(), binary.nodes.size());
  for (std::size_t n = 0; n < same.nodes.size(); ++n) {
    EXPECT_EQ(range_of(same.nodes[n]), range_of(binary.nodes[n]));
    if (!same.nodes[n].is_leaf()) {
      EXPECT_EQ(same.nodes[n].first_child, binary.nodes[n].first_child);
    }
  }
  EXPECT_EQ(collapse(binary, 0).nodes.size(), 1 + shape.triangles.size());
}

TEST(LevelStatistics, CountAllNodesFromTheRootDown) {
  const Shape shape = test::make_limb(30, 12, 3);
  const SphereTree tree = build_sphere_tree(shape.rest_positions, shape.triangles);
  const std::vector<LevelStatistics> levels = level_statistics(tree);
  EXPECT_EQ(levels[0].nodes, 1u);
  EXPECT_EQ(levels[0].mean_radius, static_cast<double>(tree.nodes[0].rest.radius));
  EXPECT_EQ(levels[1].nodes, tree.nodes[0].child_count);
  std::uint32_t nodes = 0, leaves = 0, max_children = 0;
  double radii = 0, expected_radii = 0;
  for (const LevelStatistics& level : levels) {
    nodes += level.nodes;
    leaves += level.leaves;
    radii += level.mean_radius * level.nodes;
    max_children = std::max(max_children, level.max_children);
  }
  for (const Node& node : tree.nodes) expected_radii += static_cast<double>(node.rest.radius);
  EXPECT_EQ(nodes, tree.nodes.size());
  EXPECT_EQ(leaves, shape.triangles.size());
  EXPECT_NEAR(radii, expected_radii, 1e-9 * expected_radii);
  EXPECT_GT(max_children, 2u);
  EXPECT_EQ(levels.back().leaves, levels.back().nodes);
  EXPECT_LT(levels.size(), level_statistics(binary_tree(shape)).size());
  // Each surviving inner node is smaller than 0.6 of its parent, so each level is on average, too.
  for (std::size_t l = 1; l < levels.size(); ++l)
    EXPECT_LT(levels[l].mean_radius, levels[l - 1].mean_radius);
}

TEST(LevelStatistics, TakeRefittedRadii) {
  const Shape shape = test::make_limb(6, 6, 3);
  const SphereTree tree = build_sphere_tree(shape.rest_positions, shape.triangles);
  for (const LevelStatistics& level :
       level_statistics(tree, std::vector<float>(tree.nodes.size(), 2)))
    EXPECT_EQ(level.mean_radius, 2);
}

}  // namespace
}  // namespace pelt::paper
