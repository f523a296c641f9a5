#include "evaluation/peers/peer_figures.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::peers {
namespace {

using Contacts = std::vector<Contact>;

const Contacts kExact = {{1, 5}, {2, 3}, {2, 4}};

TEST(Compare, OrderMeansNothing) {
  EXPECT_EQ(compare(Contacts{{2, 4}, {1, 5}, {2, 3}}, kExact), Difference{});
  EXPECT_EQ(compare({}, {}), Difference{});
}

TEST(Compare, CountsWhatIsMissing) {
  EXPECT_EQ(compare(Contacts{{2, 3}}, kExact), (Difference{2, 0, 0}));
  EXPECT_EQ(compare({}, kExact), (Difference{3, 0, 0}));
}

TEST(Compare, CountsWhatIsTooMuch) {
  EXPECT_EQ(compare(Contacts{{1, 5}, {2, 3}, {2, 4}, {3, 2}}, kExact), (Difference{0, 1, 0}));
  EXPECT_EQ(compare(kExact, {}), (Difference{0, 3, 0}));
}

TEST(Compare, CountsRepetitionsApart) {
  EXPECT_EQ(compare(Contacts{{2, 3}, {2, 3}, {9, 9}, {9, 9}, {9, 9}}, kExact),
            (Difference{2, 1, 3}));
}

TEST(Compare, PairsHaveASide) {
  EXPECT_EQ(compare(Contacts{{5, 1}, {2, 3}, {2, 4}}, kExact), (Difference{1, 1, 0}));
}

TEST(Compare, DifferencesAdd) {
  Difference sum = {1, 2, 3};
  sum += {10, 20, 30};
  EXPECT_EQ(sum, (Difference{11, 22, 33}));
}

}  // namespace
}  // namespace pelt::peers
