#include "model/clusters.hpp"

#include "meshes.hpp"
#include "model/model.hpp"
#include "model/tree.hpp"
#include "model/triangle_places.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelt::detail {
namespace {

using test::Random;
using test::Shape;
using Samples = std::vector<std::vector<Vec3>>;

ClusterTree build(const std::vector<Triangle>& triangles, const Samples& samples) {
  return build_cluster_tree(SampleBoxes(triangles, samples));
}

ClusterTree build(const Shape& shape) { return build(shape.triangles, {shape.rest_positions}); }

/// Small triangles at these positions.
Shape triangles_at(const std::vector<Vec3>& places, float size = 0.01f) {
  Shape shape;
  for (const Vec3& p : places) {
    const auto v = static_cast<std::uint32_t>(shape.rest_positions.size());
    shape.rest_positions.push_back(p);
    shape.rest_positions.push_back({p.x + size, p.y, p.z});
    shape.rest_positions.push_back({p.x, p.y + size, p.z + size});
    shape.triangles.push_back({v, v + 1, v + 2});
  }
  return shape;
}

double area_of(const std::vector<Triangle>& triangles, std::span<const std::uint32_t> set,
               const std::vector<Vec3>& positions) {
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (const std::uint32_t t : set)
    for (const std::uint32_t v : triangles[t]) {
      const double p[3] = {positions[v].x, positions[v].y, positions[v].z};
      for (int a = 0; a < 3; ++a)
        low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    }
  const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
  return x * y + y * z + z * x;
}

/// Checks all promises of the header. Returns the number of clusters.
std::uint32_t expect_sound(const ClusterTree& tree, const std::vector<Triangle>& triangles,
                           const Samples& samples) {
  std::vector<std::uint32_t> sorted = tree.triangle_order;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted.size(), triangles.size());
  for (std::uint32_t t = 0; t < sorted.size(); ++t) EXPECT_EQ(sorted[t], t);

  std::uint32_t clusters = 0, next_child = 1;
  std::vector<std::uint32_t> depths(tree.nodes.size(), 1);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const ClusterTreeNode& node = tree.nodes[n];
    const std::span set(tree.triangle_order.data() + node.first, node.count);
    double area = 0;
    for (const auto& positions : samples) area += area_of(triangles, set, positions);
    area /= static_cast<double>(samples.size());
    EXPECT_NEAR(node.area, area, 1e-5 * area);
    EXPECT_GT(node.count, 0u);
    EXPECT_LE(depths[n], kMaxClusterTreeDepth);
    if (node.is_cluster()) {
      EXPECT_LE(node.count, kMaxClusterTriangles);
      ++clusters;
      continue;
    }
    EXPECT_GT(node.count, kMaxClusterTriangles) << "what fits a cluster is one";
    EXPECT_EQ(node.left_child, next_child);
    next_child += 2;
    const ClusterTreeNode &left = tree.nodes[node.left_child], &right = (&left)[1];
    EXPECT_EQ(left.first, node.first);
    EXPECT_EQ(right.first, left.first + left.count);
    EXPECT_EQ(left.count + right.count, node.count);
    depths[node.left_child] = depths[node.left_child + 1] = depths[n] + 1;
  }
  EXPECT_EQ(next_child, tree.nodes.size());
  return clusters;
}

std::uint32_t expect_sound(const Shape& shape) {
  return expect_sound(build(shape), shape.triangles, {shape.rest_positions});
}

TEST(Clusters, FewTrianglesAreOneCluster) {
  Random random(72);
  for (std::uint32_t count : {1u, 2u, 15u, 16u})
    EXPECT_EQ(expect_sound(test::make_soup(random, count, 2, 2, test::Weights::random)), 1u);
  EXPECT_EQ(expect_sound(test::make_soup(random, 17, 2, 2, test::Weights::random)), 2u);
}

TEST(Clusters, AreWellFilledOnASkin) {
  for (std::uint32_t rings : {20u, 41u, 77u, 150u}) {
    const Shape limb = test::make_limb(rings, 24, 6);
    const double fill = static_cast<double>(limb.triangles.size()) / expect_sound(limb);
    EXPECT_GT(fill, 13) << rings;
  }
}

TEST(Clusters, AnySoupIsDivided) {
  Random random(73);
  for (std::uint32_t count : {18u, 100u, 255u, 256u, 257u, 1000u, 5000u})
    expect_sound(test::make_soup(random, count, 4, 3, test::Weights::random));
}

TEST(Clusters, TrianglesInOnePlaceAreDividedByCount) {
  for (std::uint32_t count : {17u, 256u, 257u, 3000u}) {
    const Shape shape = triangles_at(std::vector<Vec3>(count, Vec3{1, 2, 3}));
    EXPECT_EQ(expect_sound(shape), (count + 15) / 16) << "all clusters full";
  }
}

TEST(Clusters, TrianglesWithoutAreaAreDivided) {
  std::vector<Vec3> places;
  for (int i = 0; i < 2000; ++i) places.push_back({static_cast<float>(i), 0, 0});
  EXPECT_EQ(expect_sound(triangles_at(places, 0)), 125u) << "points on a line";
  EXPECT_EQ(expect_sound(triangles_at(std::vector<Vec3>(2000, Vec3{}), 0)), 125u) << "one point";
}

TEST(Clusters, CutsBetweenTwoClumps) {
  Random random(74);
  for (const std::uint32_t count : {240u, 320u}) {  // cut between triangles, and between bins
    std::vector<Vec3> places;
    for (std::uint32_t i = 0; i < count; ++i) {
      Vec3 p = random.point(1);
      if (i % 5 == 0) p.y += 100;
      places.push_back(p);
    }
    const ClusterTree tree = build(triangles_at(places));
    EXPECT_EQ(tree.nodes[1].count, count * 4 / 5);
    const auto right = tree.triangle_order.begin() + tree.nodes[2].first;
    EXPECT_TRUE(std::all_of(right, right + count / 5, [](std::uint32_t t) { return t % 5 == 0; }));
  }
}

/// Along each axis, positions that shrink by powers, and all others at the origin: the best cut
/// removes a single triangle again and again.
TEST(Clusters, StayWithinTheDepth) {
  std::vector<Vec3> places(400, Vec3{});
  float at = 0x1p50f;
  for (int i = 0; i < 36; ++i, at /= 20) {
    places.push_back({at, 0, 0});
    places.push_back({0, at, 0});
    places.push_back({0, 0, at});
  }
  const Shape shape = triangles_at(places, 0x1p-110f);
  expect_sound(shape);
  const ClusterTree tree = build(shape);
  const auto single = [](const ClusterTreeNode& node) { return node.count == 1; };
  EXPECT_GT(std::count_if(tree.nodes.begin(), tree.nodes.end(), single), 50);
}

TEST(Clusters, TheLargestCoordinatesDoNotOverflow) {
  Random random(75);
  Shape shape = test::make_soup(random, 600, 3, 2, test::Weights::random);
  for (Vec3& p : shape.rest_positions) {
    const auto far = [](float c) { return c < 0 ? -0x1p60f : 0x1p60f; };
    p = {far(p.x), far(p.y), far(p.z)};
  }
  expect_sound(shape);
}

TEST(Clusters, KeepApartWhatMovesApart) {
  Random random(76);
  std::vector<Vec3> places;
  for (int i = 0; i < 512; ++i) places.push_back(random.point(1));
  const Shape shape = triangles_at(places);
  const auto leaves = [](std::uint32_t t) { return t % 2 == 1; };
  std::vector<Vec3> moved = shape.rest_positions;
  for (std::uint32_t t = 0; t < 512; ++t)
    if (leaves(t))
      for (const std::uint32_t v : shape.triangles[t]) moved[v].x += 1000;

  const auto mixed_clusters = [&](const Samples& samples) {
    const ClusterTree tree = build(shape.triangles, samples);
    expect_sound(tree, shape.triangles, samples);
    int mixed = 0;
    for (const ClusterTreeNode& node : tree.nodes) {
      const auto first = tree.triangle_order.begin() + node.first;
      const auto leaving = std::count_if(first, first + node.count, leaves);
      mixed += node.is_cluster() && leaving > 0 && leaving < node.count;
    }
    return mixed;
  };
  EXPECT_GT(mixed_clusters({shape.rest_positions}), 25);
  EXPECT_EQ(mixed_clusters({shape.rest_positions, moved}), 0);
}

TEST(TrianglePlaces, FindNodeAndSlotOfEachTriangle) {
  const auto model = build_model(test::make_limb(60, 20, 5).view());
  const Tree& tree = model->detail().tree;
  ASSERT_GT(tree.nodes.size(), 10u);
  std::uint32_t found = 0;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t slot = 0; slot < tree.nodes[n].cluster_count; ++slot) {
      const Cluster& cluster = tree.clusters[tree.nodes[n].first_cluster + slot];
      for (std::uint32_t i = 0; i < cluster.triangle_count; ++i, ++found) {
        const std::uint32_t place = cluster.first_triangle + i;
        EXPECT_EQ(tree.triangle_places[tree.triangle_ids[place]], place);
        EXPECT_EQ(node_of_triangle(tree, place), n);
        EXPECT_EQ(slot_of_triangle(tree, tree.nodes[n], place), slot);
      }
    }
  EXPECT_EQ(found, tree.triangle_count());
}

/// Appends the numbers of all triangles below a slot.
void append_below(const Tree& tree, const Node& node, unsigned slot,
                  std::vector<std::uint32_t>& numbers) {
  if (slot < node.cluster_count) {
    const Cluster& cluster = tree.clusters[node.first_cluster + slot];
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i)
      numbers.push_back(tree.triangle_ids[cluster.first_triangle + i]);
    return;
  }
  const Node& below = tree.nodes[node.first_child + slot - node.cluster_count];
  for (unsigned s = 0; s < unsigned{below.cluster_count} + below.child_count; ++s)
    append_below(tree, below, s, numbers);
}

TEST(TrianglesBelow, AreTheCountAndTheLowestNumberOfEachSlot) {
  const auto model = build_model(test::make_limb(60, 20, 5).view());
  const Tree& tree = model->detail().tree;
  ASSERT_GT(tree.nodes.size(), 10u);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    std::size_t below = 0;
    unsigned slot = 0;
    for (; slot < unsigned{node.cluster_count} + node.child_count; ++slot) {
      std::vector<std::uint32_t> numbers;
      append_below(tree, node, slot, numbers);
      EXPECT_EQ(triangles_below(tree, node, slot), numbers.size());
      EXPECT_EQ(tree.lowest_below[n][slot], *std::min_element(numbers.begin(), numbers.end()));
      below += numbers.size();
    }
    EXPECT_EQ(tree.triangles_below[n], below);
    for (; slot < kMaxSlots; ++slot) EXPECT_EQ(tree.lowest_below[n][slot], kNoTriangle);
  }
  EXPECT_EQ(tree.triangles_below[0], tree.triangle_count());
}

}  // namespace
}  // namespace pelt::detail
