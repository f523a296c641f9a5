#include "tools/pelt/query/pair_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>
#include <utility>

namespace pelt::tools::query {
namespace {

PairDistance pair_at(std::uint32_t a, std::uint32_t b, double distance, std::uint32_t frame) {
  PairDistance pair = {.a = a, .b = b};
  pair.distance.distance = distance;
  pair.frame = frame;
  return pair;
}

/// distance, a, b, frame
using Row = std::tuple<double, std::uint32_t, std::uint32_t, std::uint32_t>;

std::vector<Row> rows_of(std::span<const PairDistance> pairs) {
  std::vector<Row> rows;
  for (const PairDistance& pair : pairs)
    rows.push_back({pair.distance.distance, pair.a, pair.b, pair.frame});
  return rows;
}

TEST(LeastDistances, AreThoseOfAllPairsWhateverTheirOrder) {
  const std::uint32_t seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr std::size_t kMax = 10;
  LeastDistances least(kMax), of_frame(kMax);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Row> all;
  std::size_t equal = 0;
  for (std::uint32_t frame = 0; frame < 30; ++frame) {
    of_frame.clear();
    for (std::uint32_t a = 0; a < 12; ++a)
      for (std::uint32_t b = a + 1; b < 12; ++b) {
        const double distance = static_cast<double>(random() % 200);  // many are equal
        of_frame.add(pair_at(a, b, distance, frame));
        const auto [known, is_new] = all.try_emplace({a, b}, distance, a, b, frame);
        equal += !is_new && distance == std::get<0>(known->second);
        if (distance < std::get<0>(known->second)) known->second = {distance, a, b, frame};
      }
    for (const PairDistance& pair : of_frame.pairs()) least.add(pair);
  }
  std::vector<Row> expected;
  for (const auto& [pair, row] : all) expected.push_back(row);
  std::sort(expected.begin(), expected.end());
  expected.resize(kMax);
  EXPECT_EQ(rows_of(least.pairs()), expected);
  EXPECT_GT(equal, 0u);
  EXPECT_TRUE(of_frame.has_left_out());
}

TEST(LeastDistances, TellWhetherAPairWasLeftOut) {
  LeastDistances least(2);
  for (const double distance : {3.0, 1.0, 2.0}) {
    least.add(pair_at(0, 1, distance, 0));
    least.add(pair_at(0, 2, distance, 0));
    EXPECT_FALSE(least.has_left_out());
  }
  LeastDistances nearer = least;
  least.add(pair_at(1, 2, 9, 0));  // is left out
  EXPECT_TRUE(least.has_left_out());
  nearer.add(pair_at(1, 2, 0, 0));  // replaces another one
  EXPECT_TRUE(nearer.has_left_out());
}

}  // namespace
}  // namespace pelt::tools::query
