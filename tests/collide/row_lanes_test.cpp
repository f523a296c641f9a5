#include "collide/cluster_pair.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace pelt::detail {
namespace {

using Pairs = std::vector<std::pair<unsigned, unsigned>>;

Pairs contents(const RowLanes& list) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < list.size(); ++i) pairs.emplace_back(list.row(i), list.lane(i));
  return pairs;
}

TEST(RowLanes, ListsTheLanesOfEverySetOfBits) {
  for (unsigned lanes = 0; lanes < 0x10000; ++lanes) {
    const unsigned row = lanes % 16;
    Pairs expected;
    for (unsigned lane = 0; lane < 16; ++lane)
      if (lanes >> lane & 1) expected.emplace_back(row, lane);
    RowLanes list;
    list.add(row, lanes);
    ASSERT_EQ(contents(list), expected) << "lanes " << lanes;
  }
}

TEST(RowLanes, KeepsTheOrderOfRowsUpToAllPairs) {
  Pairs expected;
  RowLanes list;
  for (unsigned row = 0; row < 16; ++row) {
    list.add(15 - row, 0);
    list.add(row, 0xFFFF);
    for (unsigned lane = 0; lane < 16; ++lane) expected.emplace_back(row, lane);
  }
  EXPECT_EQ(contents(list), expected);
}

}  // namespace
}  // namespace pelt::detail
