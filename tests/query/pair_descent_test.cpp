/// The descent visits each pair of overlapping clusters of two trees once.

#include "query/pair_descent.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "support/allocation_count.hpp"
#include "support/random.hpp"
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

TEST(Stack, HoldsWhatAVectorHolds) {
  test::Random random(60);
  Stack<Contact> stack;
  std::vector<Contact> expected;
  for (int step = 0; step < 20'000; ++step) {
    if (!expected.empty() && random.chance(0.4)) {
      EXPECT_EQ(stack.pop(), expected.back());
      expected.pop_back();
    } else {
      expected.push_back({random.index(1000), random.index(1000)});
      stack.push(expected.back());
    }
    if (random.chance(0.0005)) {
      const std::size_t size = random.index(2000);
      stack.shrink(size);
      if (size < expected.size()) expected.resize(size);
    }
    ASSERT_EQ(stack.size(), expected.size());
    ASSERT_EQ(stack.empty(), expected.empty());
  }
  EXPECT_EQ(std::vector<Contact>(stack.begin(), stack.end()), expected);
  stack.clear();
  EXPECT_TRUE(stack.empty());
}

TEST(Stack, AllocatesNothingBelowWhatItOnceHeldOrReserved) {
  Stack<SlotPair> grown, reserved;
  for (std::uint32_t i = 0; i < 5000; ++i) grown.push({i, 0, 0, 0});
  reserved.reserve(5000);
  reserved.push({1, 2, 3, 4});
  grown.clear();
  const std::size_t before = test::allocation_count();
  for (std::uint32_t i = 0; i < 4999; ++i) {
    grown.push({i, 0, 0, 0});
    reserved.push({i, 0, 0, 0});
  }
  EXPECT_EQ(test::allocation_count(), before);
  reserved.reserve(10'000);
  EXPECT_GT(test::allocation_count(), before);
  EXPECT_EQ(reserved.begin()->node_b, 3u) << "growing keeps the content";
}

}  // namespace
}  // namespace pelt::detail

namespace pelt {
namespace {

using detail::Stack;

/// Contacts of triangles below `limit`.
std::vector<Contact> random_contacts(test::Random& random, std::size_t count, std::uint32_t limit) {
  std::vector<Contact> contacts(count);
  for (Contact& contact : contacts) {
    contact.triangle_a = random.index(limit);
    contact.triangle_b = random.index(limit);
  }
  return contacts;
}

TEST(SortContacts, AsComparingWould) {
  test::Random random(31);
  Stack<Contact> contacts, buffer;
  for (const std::size_t count : {0, 1, 2, 47, 48, 49, 1000, 20000})
    for (const std::uint32_t limit : {1u, 2u, 256u, 257u, 70000u, 0x7FFFFFFFu}) {
      std::vector<Contact> expected = random_contacts(random, count, limit);
      contacts.clear();
      for (const Contact& contact : expected) contacts.push(contact);
      std::sort(expected.begin(), expected.end());
      sort_contacts(contacts, buffer);
      EXPECT_EQ(std::vector<Contact>(contacts.begin(), contacts.end()), expected)
          << count << " below " << limit;
    }
}

}  // namespace
}  // namespace pelt

namespace pelt::detail {
namespace {

TEST(SortNumbers, AsTheStandardDoes) {
  test::Random random(580);
  Stack<std::uint32_t> numbers, buffer;
  for (const std::size_t size : {0u, 1u, 2u, 95u, 96u, 97u, 1000u, 30000u})
    for (const int bits : {1, 8, 9, 16, 17, 32}) {
      numbers.clear();
      for (std::size_t i = 0; i < size; ++i)
        numbers.push(static_cast<std::uint32_t>(random.bits() >> (64 - bits)));
      std::vector<std::uint32_t> expected(numbers.begin(), numbers.end());
      std::sort(expected.begin(), expected.end());
      sort_numbers(numbers, buffer);
      EXPECT_TRUE(std::equal(expected.begin(), expected.end(), numbers.begin(), numbers.end()))
          << size << " of " << bits << " bits";
    }
}

}  // namespace
}  // namespace pelt::detail
