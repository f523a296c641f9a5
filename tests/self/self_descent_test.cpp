#include "self/self_descent.hpp"

#include "model/model.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

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
