#include "crowd/broad_phase.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pelt::detail {
namespace {

std::vector<CrowdPair> island(const Islands& islands, std::uint32_t g) {
  return {islands[g].begin(), islands[g].end()};
}

TEST(Islands, OfNoPairsAreNone) {
  Islands islands;
  EXPECT_EQ(islands.count(), 0u);
  islands.form({}, 5);
  EXPECT_EQ(islands.count(), 0u);
}

TEST(Islands, KeepTheOrderOfPairsAndOfFirstPairs) {
  Islands islands;
  const std::vector<CrowdPair> pairs = {{4, 5}, {0, 2}, {5, 7}, {1, 3}, {2, 6}, {1, 2}};
  islands.form(pairs, 9);
  ASSERT_EQ(islands.count(), 2u);
  EXPECT_EQ(island(islands, 0), (std::vector<CrowdPair>{{4, 5}, {5, 7}}));
  EXPECT_EQ(island(islands, 1), (std::vector<CrowdPair>{{0, 2}, {1, 3}, {2, 6}, {1, 2}}));
}

TEST(Islands, ShareNoInstanceAndCannotBeSplit) {
  test::Random random(50);
  Islands islands;
  std::size_t most = 0;
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t instances = 2 + random.index(60);
    std::vector<CrowdPair> pairs(random.index(instances));
    for (CrowdPair& pair : pairs) {
      pair.instance_b = 1 + random.index(instances - 1);
      pair.instance_a = random.index(pair.instance_b);
    }
    islands.form(pairs, instances);
    std::vector<CrowdPair> all;
    std::set<std::uint32_t> seen;
    for (std::uint32_t g = 0; g < islands.count(); ++g) {
      std::set<std::uint32_t> reached = {islands[g][0].instance_a};
      for (std::size_t step = 0; step < islands[g].size(); ++step)
        for (const auto& [a, b] : islands[g])
          if (reached.contains(a) || reached.contains(b)) reached.insert({a, b});
      for (const auto& [a, b] : islands[g]) ASSERT_TRUE(reached.contains(a));
      for (const std::uint32_t instance : reached) ASSERT_TRUE(seen.insert(instance).second);
      all.insert(all.end(), islands[g].begin(), islands[g].end());
    }
    std::sort(all.begin(), all.end());
    std::sort(pairs.begin(), pairs.end());
    ASSERT_EQ(all, pairs);
    most = std::max<std::size_t>(most, islands.count());
  }
  EXPECT_GT(most, 5u);
}

}  // namespace
}  // namespace pelt::detail
