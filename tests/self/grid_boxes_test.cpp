/// Boxes on the grid contain what the exact boxes contain: whatever overlaps exactly overlaps on
/// the grid, for poses of any size, also for flat ones.

#include "grid_lanes.hpp"
#include "model/model.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "support/instruction_sets.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace pelt::test {
namespace {

struct Compiled {
  InstructionSet set;
  GridLanes* grid_boxes;
};

constexpr Compiled kCompiled[] = {
    {InstructionSet::scalar, scalar::grid_boxes},
#ifdef PELT_HAS_SIMD128
    {InstructionSet::simd128, simd128::grid_boxes},
#endif
#ifdef PELT_HAS_AVX2
    {InstructionSet::avx2, avx2::grid_boxes},
#endif
};

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
  const GridBoxesOfCluster boxes = kCompiled[0].grid_boxes(posed, nodes.data(), a, b);
  const GridBoxesOfCluster others = kCompiled[0].grid_boxes(posed, nodes.data(), b, a);
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
  for (const Compiled& compiled : kCompiled) {
    if (!runs_here(compiled.set)) continue;
    const GridBoxesOfCluster same = compiled.grid_boxes(posed, nodes.data(), a, b);
    EXPECT_EQ(std::memcmp(&same, &boxes, sizeof same), 0) << name_of(compiled.set);
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
