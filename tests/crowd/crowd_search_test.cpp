/// Searches of a crowd under a budget.

#include "crowd/test_crowd.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using namespace test;

/// The answer of `Crowd::search`.
struct Answer {
  std::vector<CrowdContact> contacts;
  std::vector<UndecidedPair> undecided;
  CrowdStats stats;

  bool is_undecided(const CrowdPair& pair) const {
    return std::any_of(undecided.begin(), undecided.end(),
                       [&](const UndecidedPair& u) { return u.instances == pair; });
  }
};

Answer search(Crowd& crowd, const CrowdBudget& budget, const CrowdOptions& options = {}) {
  Answer answer;
  answer.stats = crowd.search(answer.contacts, answer.undecided, budget, options);
  EXPECT_EQ(answer.stats.cut_short, !answer.undecided.empty());
  EXPECT_TRUE(std::is_sorted(answer.contacts.begin(), answer.contacts.end()));
  EXPECT_EQ(answer.stats.intersecting_pairs, pairs_of(answer.contacts).size());
  return answer;
}

TEST(CrowdSearch, WithoutALimitFindsTheContactsOfCollide) {
  Random random(640);
  for (int round = 0; round < 4; ++round) {
    TestCrowd crowd = make_mixed_crowd(random, 12, 1);
    const auto expected = crowd.contacts();
    ASSERT_GT(expected.size(), 50u);
    for (const SearchOrder order : {SearchOrder::contacts, SearchOrder::resolution}) {
      const Answer answer = search(crowd.crowd, {.slice = 700, .order = order});
      EXPECT_EQ(answer.contacts, expected);
    }
    const Answer first = search(crowd.crowd, {.slice = 700});
    EXPECT_EQ(pairs_of(first.contacts), pairs_of(expected));
    EXPECT_LT(first.contacts.size(), expected.size());
    EXPECT_EQ(crowd.contacts(), expected) << "later queries find no open node of the search";
  }
}

TEST(CrowdSearch, IsTheSameForAnyNumberOfThreadsAndInstructionSet) {
  Random random(641);
  std::size_t undecided = 0, contacts = 0;
  TestCrowd crowd = make_mixed_crowd(random, 20, 1);
  search(crowd.crowd, {.work = 0});  // counts the boxes of all instances
  for (const std::uint64_t work : {3'000u, 20'000u, 100'000u}) {
    const CrowdBudget budget = {.work = work, .slice = 500, .order = SearchOrder::contacts};
    const Answer one = search(crowd.crowd, budget, {.threads = 1});
    on_each_instruction_set([&](InstructionSet) {
      for (const std::uint32_t threads : kThreadCounts) {
        const Answer answer = search(crowd.crowd, budget, {.threads = threads});
        EXPECT_EQ(answer.contacts, one.contacts);
        EXPECT_EQ(answer.undecided, one.undecided);
        EXPECT_EQ(work_of(answer.stats), work_of(one.stats));
      }
    });
    undecided += one.undecided.size();
    contacts += one.contacts.size();
  }
  EXPECT_GT(undecided, 20u);
  EXPECT_GT(contacts, 100u);
}

TEST(CrowdSearch, WhatItMissesIsInUndecidedPairs) {
  Random random(642);
  TestCrowd crowd = make_mixed_crowd(random, 16, 1);
  const auto expected = crowd.contacts();
  std::size_t missing = 0;
  std::vector<CrowdContact> known;
  for (std::uint64_t work = 1000; work < 200'000; work *= 2) {
    const Answer answer =
        search(crowd.crowd, {.work = work, .slice = 300, .order = SearchOrder::contacts});
    ASSERT_TRUE(std::includes(expected.begin(), expected.end(), answer.contacts.begin(),
                              answer.contacts.end()));
    for (const CrowdContact& contact : expected)
      if (!std::binary_search(answer.contacts.begin(), answer.contacts.end(), contact)) {
        ASSERT_TRUE(answer.is_undecided({contact.instance_a, contact.instance_b}));
        ++missing;
      }
    ASSERT_GE(answer.contacts.size(), known.size());
    known = answer.contacts;
  }
  EXPECT_GT(missing, 100u);
}

TEST(CrowdSearch, HeavyPairsComeFirst) {
  Random random(643);
  TestCrowd crowd = make_mixed_crowd(random, 16, 1);
  std::vector<CrowdContact> contacts;
  std::vector<UndecidedPair> all;
  crowd.crowd.search(contacts, all, {.work = 0});
  ASSERT_GT(all.size(), 10u);
  EXPECT_TRUE(contacts.empty());
  for (const UndecidedPair& favourite : {all[2], all[all.size() / 2], all.back()}) {
    const auto weight = [&](std::uint32_t a, std::uint32_t b) {
      return CrowdPair{a, b} == favourite.instances ? 2.0 : 1.0;
    };
    // Work for one step: all other pairs remain as they were.
    const Answer answer = search(crowd.crowd, {.work = 1, .weight = weight});
    EXPECT_EQ(std::count(answer.undecided.begin(), answer.undecided.end(), favourite), 0);
    for (const UndecidedPair& pair : all)
      if (pair.instances != favourite.instances) {
        EXPECT_EQ(std::count(answer.undecided.begin(), answer.undecided.end(), pair), 1);
      }
  }
}

TEST(CrowdSearch, ObeysMasksAndFilter) {
  Random random(644);
  TestCrowd crowd = make_mixed_crowd(random, 16, 1);
  const CrowdOptions even = {
      .filter = [](std::uint32_t a, std::uint32_t b) { return (a + b) % 2 == 0; }};
  const auto expected = crowd.contacts(even);
  ASSERT_GT(expected.size(), 20u);
  EXPECT_EQ(search(crowd.crowd, {.order = SearchOrder::contacts}, even).contacts, expected);
}

TEST(CrowdSearchDeathTest, ASliceOfNothingAborts) {
  Random random(645);
  TestCrowd crowd = make_mixed_crowd(random, 4, 0.1);
  EXPECT_DEATH(search(crowd.crowd, {.slice = 0}), "Crowd::search: the slice is 0");
}

}  // namespace
}  // namespace pelt
