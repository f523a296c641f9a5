/// The descent visits each pair of overlapping clusters of two trees once.

#include "query/pair_descent.hpp"

#include "pose/pose.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pelt::detail {
namespace {

using test::Random;
using ClusterPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::uint32_t index_of(const PosedCluster& c) { return c.node.first_cluster + c.slot; }

/// Collects the pairs of clusters.
struct VisitClusters : BoxOverlap {
  void test(const PosedCluster& a, const PosedCluster& b) {
    pairs.emplace_back(index_of(a), index_of(b));
  }
  bool is_full() const { return pairs.size() >= limit; }
  bool is_impatient() const { return limit < 10; }

  std::size_t limit = SIZE_MAX;
  ClusterPairs pairs;
};

/// All clusters of a pose in order, with their nodes opened.
std::vector<PosedCluster> all_clusters(const PosedTree& posed) {
  make_table(posed);
  QueryStats work;
  std::vector<PosedCluster> clusters;
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n) {
    const OpenedNode& opened = open_node(posed, n, work);
    for (std::uint32_t slot = 0; slot < posed.tree.nodes[n].cluster_count; ++slot)
      clusters.push_back({posed, posed.tree.nodes[n], opened, slot});
  }
  return clusters;
}

bool overlap(const PosedCluster& a, const PosedCluster& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.opened.high[axis][a.slot] < b.opened.low[axis][b.slot] ||
        b.opened.high[axis][b.slot] < a.opened.low[axis][a.slot])
      return false;
  return true;
}

ClusterPairs sorted(ClusterPairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

class PairDescentTest : public testing::Test {
 protected:
  PairDescentTest()
      : model_(*build_model(test::make_limb(40, 16, 5).view())), a_(model_), b_(model_) {}

  void move(Random& random) {
    ASSERT_TRUE(a_.set_palette(test::bend_limb(random, 5, 0.8, random.point(0.2))));
    ASSERT_TRUE(b_.set_palette(test::bend_limb(random, 5, 0.8, random.point(0.2))));
  }

  PosedTree tree_a() { return a_.detail().posed_tree(); }
  PosedTree tree_b() { return b_.detail().posed_tree(); }

  SkinnedModel model_;
  pelt::Pose a_, b_;
  Stack<SlotPair> pairs_;
  QueryStats work_;
};

TEST_F(PairDescentTest, VisitsOverlappingClustersOfTwoTreesOnce) {
  Random random(960);
  std::size_t visited = 0, all = 0;
  for (int round = 0; round < 10; ++round) {
    move(random);
    const PosedTree a = tree_a(), b = tree_b();
    ClusterPairs expected;
    const std::vector<PosedCluster> clusters_a = all_clusters(a), clusters_b = all_clusters(b);
    for (const PosedCluster& x : clusters_a)
      for (const PosedCluster& y : clusters_b)
        if (overlap(x, y)) expected.emplace_back(index_of(x), index_of(y));
    VisitClusters rule;
    pairs_.push({0, kAllSlots, 0, kAllSlots});
    PairDescent descent(a, b, pairs_, rule, work_);
    descent.run();
    EXPECT_FALSE(descent.is_unfinished());
    EXPECT_EQ(sorted(rule.pairs), sorted(expected));
    visited += expected.size();
    all += clusters_a.size() * clusters_b.size();
  }
  EXPECT_GT(visited, 100u);
  EXPECT_LT(visited, all / 4);
}

TEST_F(PairDescentTest, EndsWhenTheRuleIsFull) {
  Random random(962);
  std::size_t ended = 0;
  for (int round = 0; round < 10; ++round) {
    move(random);
    const PosedTree a = tree_a(), b = tree_b();
    make_table(a), make_table(b);
    VisitClusters rule;
    rule.limit = 3;
    pairs_.clear();
    pairs_.push({0, kAllSlots, 0, kAllSlots});
    PairDescent descent(a, b, pairs_, rule, work_);
    descent.run();
    EXPECT_LE(rule.pairs.size(), 3u);
    EXPECT_EQ(descent.is_unfinished(), rule.pairs.size() == 3);
    ended += descent.is_unfinished();
  }
  EXPECT_GT(ended, 3u);
}

}  // namespace
}  // namespace pelt::detail
