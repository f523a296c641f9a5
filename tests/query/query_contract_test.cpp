/// The promises of every query, asserted for each row of the table in support/contract.

#include "support/allocation_count.hpp"
#include "support/contract/query.hpp"
#include "support/instruction_sets.hpp"

#include "exact/predicates.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace pelt::contract {
namespace {

using test::on_each_instruction_set;

constexpr std::size_t kMaxElements = 60'000;

auto counts(const QueryStats& work) {
  return std::tuple(work.node_pairs, work.refits, work.posed_vertices, work.triangle_pairs,
                    work.displacements, work.clamped_offsets, work.cut_short);
}

/// The work of a query without what later queries need not do again.
auto tests_in(const QueryStats& work) { return std::tuple(work.node_pairs, work.triangle_pairs); }

class EachQuery : public testing::TestWithParam<std::size_t> {
 protected:
  Query& query() const { return *queries()[GetParam()]; }

  /// Calls `test(stage)` for bodies of each kind, `rounds` times: near, less near, apart.
  template <typename Test>
  void on_all_kinds(std::uint64_t seed, int rounds, const Test& test) {
    const bool is_sampled = query().traits.is_costly && rounds < 3;  // every second kind
    if (query().traits.is_costly) rounds = 1;
    const std::span<const Kind> all = kinds();
    constexpr double kDistances[] = {0.15, 0.6, 3};
    Random random(seed + GetParam());
    for (std::size_t k = 0; k < all.size(); ++k)
      for (int round = 0; round < rounds; ++round) {
        if (is_sampled && (k + seed / 1000) % 2 == 0) continue;
        const Kind& kind = all[k];
        SCOPED_TRACE(testing::Message() << kind.name << ", round " << round);
        Stage stage(random, kind, kDistances[(k + static_cast<std::size_t>(round)) % 3],
                    query().traits.is_costly ? 1 : 5);
        kind_ = &kind;
        if (!query().preparation.applies(stage)) continue;
        query().preparation.arrange(stage);
        query().preparation.make(stage);
        test(stage);
        if (HasFailure()) return;  // one stage shows enough
        ++cases_;
        touching_ += query().hits() > 0;
        hits_ += query().hits();
      }
  }

  /// Expects that the cases so far have tested something.
  void expect_hits(bool and_misses = false) {
    RecordProperty("cases", cases_);
    RecordProperty("touching", touching_);
    RecordProperty("hits", static_cast<int>(hits_));
    EXPECT_GT(cases_, 10);
    EXPECT_GT(touching_, cases_ / 8);
    if (and_misses && !query().traits.always_hits) {
      EXPECT_LT(touching_, cases_);
    }
  }

  /// Makes what the query keeps anew, too.
  void close(Stage& stage, bool reserved) {
    stage.close(reserved);
    query().preparation.make(stage);
  }

  const Kind* kind_ = nullptr;
  int cases_ = 0, touching_ = 0;
  std::size_t hits_ = 0;
};

TEST_P(EachQuery, EqualsBruteForceByTheSameWorkOnEachInstructionSet) {
  std::uint64_t exact_signs = 0;
  on_all_kinds(1000, 3, [&](Stage& stage) {
    std::optional<Numbers> first;
    QueryStats first_work;
    std::uint64_t first_signs = 0;
    bool reserved = false;
    on_each_instruction_set([&](InstructionSet) {
      close(stage, reserved);
      reserved = true;
      const std::uint64_t before = detail::exact_sign_count();
      const QueryStats work = query().ask(stage);
      const std::uint64_t signs = detail::exact_sign_count() - before;
      EXPECT_FALSE(work.cut_short);
      if (!first) {
        first = query().numbers(), first_work = work, first_signs = signs;
        query().expect_right(stage);
        for (const Pose* pose : {&stage.a.from, &stage.a.to, &stage.b.from, &stage.b.to})
          EXPECT_EQ(check_bounds(*pose), "");
      }
      EXPECT_EQ(query().numbers(), *first);
      EXPECT_EQ(counts(work), counts(first_work));
      EXPECT_EQ(signs, first_signs);
    });
    if (kind_->needs_exact_signs) exact_signs += first_signs;
  });
  expect_hits(true);
  RecordProperty("exact_signs", static_cast<int>(exact_signs));
  if (query().name == "Collide") {
    EXPECT_GT(exact_signs, 100u);
  }
}

TEST_P(EachQuery, CountsItsWorkAndOpensNothingTwice) {
  on_all_kinds(2000, 1, [&](Stage& stage) {
    const QueryStats cold = query().ask(stage);
    if (!query().traits.reserves_when_asked) {
      EXPECT_GT(cold.node_pairs + cold.refits, 0u);
    }
    const Numbers answer = query().numbers();
    const QueryStats warm = query().ask(stage);
    EXPECT_EQ(query().numbers(), answer);
    if (query().traits.varies_in_work) return;
    EXPECT_EQ(tests_in(warm), tests_in(cold));
    EXPECT_EQ(warm.posed_vertices + warm.displacements + warm.clamped_offsets, 0u);
  });
}

using EachQueryOfPlaces = EachQuery;

TEST_P(EachQueryOfPlaces, AnswersAsIfVerticesWereGiven) {
  on_all_kinds(4000, 2, [&](Stage& stage) {
    query().ask(stage);
    const Numbers answer = query().numbers();
    Stage given = stage.given();
    query().preparation.make(given);
    query().ask(given);
    EXPECT_EQ(query().numbers(), answer);
    Stage half = stage.given();  // one of the bodies
    half.a = std::move(stage.a);
    query().preparation.make(half);
    query().ask(half);
    EXPECT_EQ(query().numbers(), answer);
  });
}

/// With reserved memory from the first call on; or, if a query reserves when asked, from the second
/// on.
TEST_P(EachQuery, AllocatesNothingInReservedMemory) {
  std::uint64_t tests = 0;
  on_all_kinds(5000, 1, [&](Stage& stage) {
    on_each_instruction_set([&](InstructionSet) {
      query().ask(stage);  // the answer of this row keeps its memory
      close(stage, true);
      query().reserve(kMaxElements);
      if (query().traits.reserves_when_asked) query().ask(stage);
      const std::size_t before = test::allocation_count();
      if (!query().traits.reserves_when_asked) stage.a.set(), stage.b.set();
      const QueryStats work = query().ask(stage);
      if (!query().traits.allocates) {
        EXPECT_EQ(test::allocation_count(), before);
      }
      tests += work.node_pairs + work.triangle_pairs + work.posed_vertices;
    });
  });
  EXPECT_GT(tests, 100u);
  EXPECT_GT(test::allocation_count(), 0u) << "the counter must count";
}

using EachList = EachQuery;

TEST_P(EachList, IsAppendedTo) {
  on_all_kinds(6000, 2, [&](Stage& stage) { query().expect_appended(stage); });
  expect_hits();
}

using EachLimitedQuery = EachQuery;

TEST_P(EachLimitedQuery, StopsAtTheLimitWithPartOfTheAnswer) {
  on_all_kinds(7000, 1, [&](Stage& stage) {
    std::optional<Numbers> first;
    QueryStats first_work;
    on_each_instruction_set([&](InstructionSet) {
      close(stage, true);
      const QueryStats work = query().ask(stage, 7);
      if (!first) first = query().numbers(), first_work = work;
      EXPECT_EQ(query().numbers(), *first);
      EXPECT_EQ(counts(work), counts(first_work));
      query().expect_limits(stage);
    });
    query().ask(stage);
  });
  expect_hits();
}

/// A limit also limits the room that must be reserved.
TEST_P(EachLimitedQuery, NeedsNoMoreMemoryThanForTheLimit) {
  int stopped = 0;
  on_all_kinds(8000, 1, [&](Stage& stage) {
    for (const std::uint32_t limit : {20u, 1u}) {
      close(stage, true);
      stage.scratch = Scratch();
      stage.scratch.reserve(limit, 0, stage.filter.scratch_size());
      query().reserve(kMaxElements);
      if (query().traits.reserves_when_asked) query().ask(stage, limit);
      const std::size_t before = test::allocation_count();
      stopped += query().ask(stage, limit).cut_short;
      EXPECT_EQ(test::allocation_count(), before);
    }
  });
  EXPECT_GT(stopped, 4);
}

using EachQueryOfTwoBodies = EachQuery;

TEST_P(EachQueryOfTwoBodies, AnswersSwappedBodiesAlike) {
  on_all_kinds(9000, 2, [&](Stage& stage) {
    query().ask(stage);
    Stage swapped = stage.given();
    swapped.swap();
    query().preparation.make(swapped);
    query().expect_swapped(swapped);
  });
}

using EachQueryWithThreads = EachQuery;

TEST_P(EachQueryWithThreads, AnswersTheSameByTheSameWorkOnAnyNumberOfThreads) {
  on_all_kinds(10000, 1, [&](Stage& stage) {
    std::optional<Numbers> first;
    QueryStats first_work;
    for (const std::uint32_t threads : {1u, 2u, 3u, 8u}) {
      stage.threads = threads;
      query().preparation.make(stage);
      const QueryStats work = query().ask(stage);
      if (!first) first = query().numbers(), first_work = work;
      EXPECT_EQ(query().numbers(), *first);
      EXPECT_EQ(counts(work), counts(first_work));
    }
  });
  expect_hits();
}

/// Nodes that one query opens are used by all queries.
TEST(Queries, ChangeNoAnswerOfOthers) {
  Random random(11000);
  std::size_t answers = 0;
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    Stage stage(random, kind, 0.3);
    std::vector<std::pair<Query*, Numbers>> alone;
    for (const auto& query : queries()) {
      if (!query->preparation.applies(stage)) continue;
      stage.close(false);
      query->preparation.make(stage);
      query->ask(stage);
      alone.emplace_back(query.get(), query->numbers());
    }
    stage.close(false);
    std::reverse(alone.begin(), alone.end());
    for (const auto& [query, answer] : alone) {
      query->preparation.make(stage);
      query->ask(stage);
      EXPECT_EQ(query->numbers(), answer) << query->name;
      ++answers;
    }
  }
  EXPECT_GT(answers, 1000u);
}

std::vector<std::size_t> rows_with(bool (*has)(const Query&)) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < queries().size(); ++i)
    if (has(*queries()[i])) rows.push_back(i);
  return rows;
}

std::string name_of(const testing::TestParamInfo<std::size_t>& row) {
  return queries()[row.param]->name;
}

const auto kAll = rows_with([](const Query&) { return true; });
const auto kOfPlaces =
    rows_with([](const Query& query) { return !query.traits.depends_on_skinning; });
const auto kLists = rows_with([](const Query& query) { return query.is_list(); });
const auto kLimited = rows_with([](const Query& query) { return query.traits.is_limited; });
const auto kOfTwo = rows_with([](const Query& query) { return query.traits.of_two_bodies; });
const auto kWithThreads = rows_with([](const Query& query) { return query.traits.has_threads; });

INSTANTIATE_TEST_SUITE_P(Queries, EachQuery, testing::ValuesIn(kAll), name_of);
INSTANTIATE_TEST_SUITE_P(Queries, EachQueryOfPlaces, testing::ValuesIn(kOfPlaces), name_of);
INSTANTIATE_TEST_SUITE_P(Queries, EachList, testing::ValuesIn(kLists), name_of);
INSTANTIATE_TEST_SUITE_P(Queries, EachLimitedQuery, testing::ValuesIn(kLimited), name_of);
INSTANTIATE_TEST_SUITE_P(Queries, EachQueryOfTwoBodies, testing::ValuesIn(kOfTwo), name_of);
INSTANTIATE_TEST_SUITE_P(Queries, EachQueryWithThreads, testing::ValuesIn(kWithThreads), name_of);

}  // namespace
}  // namespace pelt::contract
