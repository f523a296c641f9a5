#include "crowd/pair_groups.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pelt::detail {
namespace {

std::vector<CrowdPair> group(const PairGroups& groups, std::uint32_t g) {
  return {groups[g].begin(), groups[g].end()};
}

TEST(PairGroups, OfNoPairsAreNone) {
  PairGroups groups;
  EXPECT_EQ(groups.count(), 0u);
  groups.form({}, 5);
  EXPECT_EQ(groups.count(), 0u);
}

TEST(PairGroups, KeepTheOrderOfPairsAndOfFirstPairs) {
  PairGroups groups;
  const std::vector<CrowdPair> pairs = {{4, 5}, {0, 2}, {5, 7}, {1, 3}, {2, 6}, {1, 2}};
  groups.form(pairs, 9);
  ASSERT_EQ(groups.count(), 2u);
  EXPECT_EQ(group(groups, 0), (std::vector<CrowdPair>{{4, 5}, {5, 7}}));
  EXPECT_EQ(group(groups, 1), (std::vector<CrowdPair>{{0, 2}, {1, 3}, {2, 6}, {1, 2}}));
}

TEST(PairGroups, ShareNoInstanceAndCannotBeSplit) {
  test::Random random(50);
  PairGroups groups;
  std::size_t most = 0;
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t instances = 2 + random.index(60);
    std::vector<CrowdPair> pairs(random.index(instances));
    for (CrowdPair& pair : pairs) {
      pair.instance_b = 1 + random.index(instances - 1);
      pair.instance_a = random.index(pair.instance_b);
    }
    groups.form(pairs, instances);
    std::vector<CrowdPair> all;
    std::set<std::uint32_t> seen;
    for (std::uint32_t g = 0; g < groups.count(); ++g) {
      std::set<std::uint32_t> reached = {groups[g][0].instance_a};
      for (std::size_t step = 0; step < groups[g].size(); ++step)
        for (const auto& [a, b] : groups[g])
          if (reached.contains(a) || reached.contains(b)) reached.insert({a, b});
      for (const auto& [a, b] : groups[g]) ASSERT_TRUE(reached.contains(a));
      for (const std::uint32_t instance : reached) ASSERT_TRUE(seen.insert(instance).second);
      all.insert(all.end(), groups[g].begin(), groups[g].end());
    }
    std::sort(all.begin(), all.end());
    std::sort(pairs.begin(), pairs.end());
    ASSERT_EQ(all, pairs);
    most = std::max<std::size_t>(most, groups.count());
  }
  EXPECT_GT(most, 5u);
}

}  // namespace
}  // namespace pelt::detail
