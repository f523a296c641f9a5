#include <pelt/self_filter.hpp>

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pelt::test {
namespace {

TEST(ContactTally, CountsThePosesOfEachPair) {
  Random random(1744);
  ContactTally tally;
  EXPECT_EQ(tally.pose_count(), 0u);
  EXPECT_TRUE(tally.in_share_of_poses(0).empty());
  std::map<Contact, std::uint32_t> counts;
  for (std::uint32_t pose = 1; pose <= 100; ++pose) {
    std::set<Contact> contacts;
    for (std::uint32_t i = 0; i < 30; ++i)
      if (random.index(30) <= i) contacts.insert({i % 7, 10 + i});
    for (const Contact& contact : contacts) ++counts[contact];
    tally.add(std::vector<Contact>(contacts.begin(), contacts.end()));
    EXPECT_EQ(tally.pose_count(), pose);
    ContactTally moved = std::move(tally);
    tally = std::move(moved);
  }
  for (std::uint32_t hundredths = 0; hundredths <= 100; ++hundredths) {
    std::vector<Contact> expected;
    for (const auto& [contact, count] : counts)
      if (count >= hundredths) expected.push_back(contact);
    EXPECT_EQ(tally.in_share_of_poses(hundredths / 100.0), expected) << hundredths << " %";
  }
}

}  // namespace
}  // namespace pelt::test
