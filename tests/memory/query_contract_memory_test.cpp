/// Allocation failures in each row of the table of queries in support/contract.

#include "support/contract/query.hpp"
#include "support/failing_allocation.hpp"

#include <gtest/gtest.h>

namespace pelt::contract {
namespace {

class EachQueryInMemory : public testing::TestWithParam<std::size_t> {};

/// Leaks are found by the address sanitizer, because rows keep what they prepared. The poses and
/// the scratch survive each failure, and are queried again. A failed query leaves its list as it
/// was.
TEST_P(EachQueryInMemory, EndsAndAnswersAsBeforeWhenMemoryIsBack) {
  Query& query = *queries()[GetParam()];
  // Crowds append as they go, and this row asks for one ray after the other.
  const bool appends_at_once =
      query.is_list() && !query.traits.has_threads && query.name != "CastAll";
  Random random(12000);
  Stage stage(random, kinds()[0], 0.1);
  query.preparation.arrange(stage);
  const auto renew = [&] {
    stage.close(false);
    query.preparation.make(stage);
  };
  const auto ask = [&] {
    query.reserve(0);
    query.ask(stage);
  };
  renew();
  ask();
  const Numbers answer = query.numbers();
  EXPECT_GT(query.hits(), 0u);
  renew();
  const std::size_t failures = test::fail_each_allocation(ask, [&] {
    if (appends_at_once) {
      EXPECT_EQ(query.hits(), 0u);
    }
    ask();
    EXPECT_EQ(query.numbers(), answer);
    renew();
  });
  EXPECT_EQ(query.numbers(), answer);
  EXPECT_GT(failures, 0u);
  query.forget();
}

INSTANTIATE_TEST_SUITE_P(Queries, EachQueryInMemory,
                         testing::Range(std::size_t{0}, queries().size()),
                         [](const auto& row) { return queries()[row.param]->name; });

}  // namespace
}  // namespace pelt::contract
