#include "self/pair_masks.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

namespace pelt::detail {
namespace {

bool has(SlotMatrix matrix, unsigned row, unsigned column) {
  return (matrix & slot_pair(row, column)) != 0;
}

TEST(SlotMatrix, ReadsRowsAndColumns) {
  test::Random random(1750);
  for (int round = 0; round < 200; ++round) {
    const SlotMatrix matrix = random.bits();
    for (unsigned i = 0; i < 8; ++i)
      for (unsigned j = 0; j < 8; ++j) {
        EXPECT_EQ(row_of(matrix, i) >> j & 1, has(matrix, i, j));
        EXPECT_EQ(column_of(matrix, j) >> i & 1, has(matrix, i, j));
        EXPECT_LT(row_of(matrix, i) | column_of(matrix, j), 256u);
      }
  }
}

TEST(SlotMatrix, ListsPairsOfSlots) {
  test::Random random(1751);
  for (unsigned rows = 0; rows <= 8; ++rows)
    for (unsigned columns = 0; columns <= 8; ++columns)
      for (unsigned i = 0; i < 8; ++i)
        for (unsigned j = 0; j < 8; ++j)
          EXPECT_EQ(has(first_slots(rows, columns), i, j), i < rows && j < columns);
  for (int round = 0; round < 200; ++round) {
    const unsigned rows = random.index(256), columns = random.index(256);
    for (unsigned i = 0; i < 8; ++i)
      for (unsigned j = 0; j < 8; ++j)
        EXPECT_EQ(has(all_pairs(rows, columns), i, j), (rows >> i & columns >> j & 1) != 0);
  }
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned j = 0; j < 8; ++j) EXPECT_EQ(has(kLaterSlots, i, j), j > i);
}

}  // namespace
}  // namespace pelt::detail
