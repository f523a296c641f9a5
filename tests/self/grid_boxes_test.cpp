/// Boxes on the grid contain what the exact boxes contain: whatever overlaps exactly overlaps on
/// the grid, for poses of any size, also for flat ones.

#include "model/model.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "self/grid_lanes.hpp"
#include "self/self_descent.hpp"
#include "self/surface_shapes.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace pelt::test {
namespace {

constexpr Compiled<GridLanes> kGridBoxes[] = PELT_ALL_COMPILED(grid_boxes);

std::vector<std::uint32_t> cluster_nodes(const detail::Tree& tree) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    nodes.insert(nodes.end(), tree.nodes[n].cluster_count, n);
  return nodes;
}

/// A limb stretched by these factors.
std::vector<Matrix4> stretched(Random& random, const Vec3& factors) {
  std::vector<Matrix4> palette = bend_limb(random, 5, 2, random.point(1));
  const float factor[3] = {factors.x, factors.y, factors.z};
  for (Matrix4& joint : palette)
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row) joint.m[4 * column + row] *= factor[row];
  return palette;
}

struct Overlaps {
  std::size_t exact = 0, on_grid = 0, all = 0;
};

/// Compares two clusters with their exact boxes, and all instruction sets with each other.
void expect_boxes(const detail::PosedTree& posed, const std::vector<std::uint32_t>& nodes,
                  std::uint32_t a, std::uint32_t b, Overlaps& overlaps) {
  const GridBoxesOfCluster boxes = scalar::grid_boxes(posed, nodes.data(), a, b);
  const GridBoxesOfCluster others = scalar::grid_boxes(posed, nodes.data(), b, a);
  EXPECT_EQ(boxes.triangles, (1u << posed.tree.clusters[a].triangle_count) - 1);
  for (unsigned i = 0; i < 16; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(boxes.low[axis][i], boxes.high[axis][i]);
      EXPECT_LE(boxes.all_low[axis], boxes.low[axis][i]);
      EXPECT_GE(boxes.all_high[axis], boxes.high[axis][i]);
    }
    for (unsigned j = 0; j < 16; ++j) {
      bool overlap = true;
      for (int axis = 0; axis < 3; ++axis)
        overlap = overlap && boxes.exact_low[axis][i] <= others.exact_high[axis][j] &&
                  others.exact_low[axis][j] <= boxes.exact_high[axis][i];
      const bool on_grid = boxes.overlapping[i] >> j & 1;
      EXPECT_LE(overlap, on_grid);
      overlaps.exact += overlap, overlaps.on_grid += on_grid, ++overlaps.all;
    }
  }
  for (const auto& [set, grid_boxes] : kGridBoxes) {
    if (!runs_here(set)) continue;
    const GridBoxesOfCluster same = grid_boxes(posed, nodes.data(), a, b);
    EXPECT_EQ(std::memcmp(&same, &boxes, sizeof same), 0) << name_of(set);
  }
}

Overlaps compare_boxes(Random& random, const Vec3& factors) {
  const SkinnedModel model = *build_model(make_limb(40, 16, 5).view());
  const std::vector<std::uint32_t> nodes = cluster_nodes(model.detail().tree);
  pelt::Pose pose(model);
  Overlaps overlaps;
  for (int round = 0; round < 5; ++round) {
    EXPECT_TRUE(pose.set_palette(stretched(random, factors)));
    const detail::PosedTree posed = pose.detail().posed_tree();
    make_table(posed);
    open_all(posed);
    for (std::uint32_t a = 0; a < nodes.size(); ++a)
      for (std::uint32_t b = a; b < std::min<std::size_t>(a + 3, nodes.size()); ++b)
        expect_boxes(posed, nodes, a, b, overlaps);
  }
  return overlaps;
}

TEST(GridBoxes, OverlapWhereExactBoxesDoAndHardlyAnywhereElse) {
  Random random(1770);
  for (const float size : {1.0f, 0x1p-30f, 0x1p40f}) {
    const Overlaps overlaps = compare_boxes(random, {size, size, size});
    EXPECT_GT(overlaps.exact, overlaps.all / 20);
    EXPECT_LT(overlaps.exact, overlaps.all / 2);
    EXPECT_LT(overlaps.on_grid, overlaps.exact + overlaps.exact / 100);
  }
}

TEST(GridBoxes, MayOverlapMoreInFlatPoses) {
  Random random(1771);
  for (const Vec3 factors : {Vec3{1, 0, 1}, Vec3{1, 1, 1e-42f}, Vec3{0, 0, 0}}) {
    const Overlaps overlaps = compare_boxes(random, factors);
    EXPECT_GT(overlaps.exact, overlaps.all / 20);
  }
}

}  // namespace
}  // namespace pelt::test

namespace pelt::detail {
namespace {

using test::Random;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

struct VisitPairs {
  void test(std::uint32_t low, std::uint32_t high) { pairs.emplace_back(low, high); }
  bool is_full() const { return pairs.size() >= limit; }

  std::size_t limit = SIZE_MAX;
  Pairs pairs;
};

struct ClusterBox {
  float low[3], high[3];
};

std::vector<ClusterBox> cluster_boxes(const PosedTree& posed) {
  std::vector<ClusterBox> boxes;
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n)
    for (std::uint32_t slot = 0; slot < posed.tree.nodes[n].cluster_count; ++slot) {
      ClusterBox& box = boxes.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = posed.opened[n]->low[axis][slot];
        box.high[axis] = posed.opened[n]->high[axis][slot];
      }
    }
  return boxes;
}

bool overlap(const ClusterBox& a, const ClusterBox& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
  return true;
}

bool are_neighbours(const PairMasks& masks, std::uint32_t low, std::uint32_t high) {
  const auto begin = masks.others.begin();
  return std::find(begin + masks.begin[low], begin + masks.begin[low + 1], high) !=
         begin + masks.begin[low + 1];
}

class SelfDescentTest : public testing::Test {
 protected:
  SelfDescentTest()
      : model_(*build_model(test::make_limb(60, 24, 5).view())),
        fans_(model_.detail().tree),
        masks_(model_.detail().tree, fans_),
        pose_(model_) {}

  /// Bends the limb and opens all nodes.
  PosedTree move(Random& random) {
    EXPECT_TRUE(pose_.set_palette(test::bend_limb(random, 5, 2.5, {})));
    const PosedTree posed = pose_.detail().posed_tree();
    make_table(posed);
    open_all(posed);
    return posed;
  }

  SkinnedModel model_;
  Fans fans_;
  PairMasks masks_;
  pelt::Pose pose_;
  QueryStats work_;
};

TEST_F(SelfDescentTest, VisitsOverlappingClustersThatAreNoNeighboursOnce) {
  Random random(1760);
  std::size_t visited = 0, all = 0;
  for (int round = 0; round < 20; ++round) {
    const PosedTree posed = move(random);
    const std::vector<ClusterBox> boxes = cluster_boxes(posed);
    Pairs expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
        if (overlap(boxes[i], boxes[j]) && !are_neighbours(masks_, i, j))
          expected.emplace_back(i, j);
    VisitPairs rule;
    SelfDescent(posed, masks_, rule, work_).run();
    std::sort(rule.pairs.begin(), rule.pairs.end());
    EXPECT_EQ(rule.pairs, expected);
    visited += expected.size();
    all += boxes.size() * (boxes.size() - 1) / 2;
  }
  EXPECT_GT(visited, 1000u);
  EXPECT_LT(visited, all / 4);
}

TEST_F(SelfDescentTest, EndsWhenTheRuleIsFull) {
  Random random(1761);
  const PosedTree posed = move(random);
  VisitPairs rule;
  rule.limit = 3;
  SelfDescent(posed, masks_, rule, work_).run();
  EXPECT_EQ(rule.pairs.size(), 3u);
}

}  // namespace
}  // namespace pelt::detail
