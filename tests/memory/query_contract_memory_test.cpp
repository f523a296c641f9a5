/// Allocation failures in each row of the table of queries in support/contract.

#include "support/contract/query.hpp"
#include "support/failing_allocation.hpp"

#include <gtest/gtest.h>

namespace pelt::contract {
namespace {

class EachQueryInMemory : public testing::TestWithParam<std::size_t> {};

/// The poses and the scratch survive each failure, and are queried again. A failed query leaves its
/// list as it was. Uses the first kind of bodies that gives the query a result.
TEST_P(EachQueryInMemory, EndsAndAnswersAsBeforeWhenMemoryIsBack) {
  Query& query = *queries()[GetParam()];
  // Crowds append as they go, and this row asks for one ray after the other.
  const bool appends_at_once =
      query.is_list() && !query.traits.has_threads && query.name != "CastAll";
  Random random(12000);
  std::size_t failures = 0;
  for (const Kind& kind : kinds()) {
    Stage stage(random, kind, 0.1);
    if (!query.preparation.applies(stage)) continue;
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
    if (query.hits() == 0) continue;
    const Numbers answer = query.numbers();
    renew();
    failures = test::fail_each_allocation(ask, [&] {
      if (appends_at_once) {
        EXPECT_EQ(query.hits(), 0u);
      }
      ask();
      EXPECT_EQ(query.numbers(), answer);
      renew();
    });
    EXPECT_EQ(query.numbers(), answer);
    break;
  }
  query.forget();
  // These two allocate when they are prepared, and not when they are asked.
  if (query.name != "FirstContactSearch" && query.name != "GroupBounds") {
    EXPECT_GT(failures, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Queries, EachQueryInMemory,
                         testing::Range(std::size_t{0}, queries().size()),
                         [](const auto& row) { return queries()[row.param]->name; });

}  // namespace
}  // namespace pelt::contract
