#include <pelt/self_filter.hpp>

#include "base/assert.hpp"

#include <algorithm>
#include <utility>

namespace pelt {

struct ContactTally::Tally {
  struct Count {
    Contact pair;
    std::uint32_t poses;
  };

  std::vector<Count> counts, merged;  // ascending by pair
  std::uint32_t pose_count = 0;
};

ContactTally::ContactTally() : tally_(std::make_unique<Tally>()) {}
ContactTally::ContactTally(ContactTally&&) noexcept = default;
ContactTally& ContactTally::operator=(ContactTally&&) noexcept = default;
ContactTally::~ContactTally() = default;

void ContactTally::add(std::span<const Contact> contacts) {
  PELT_ASSERT(std::is_sorted(contacts.begin(), contacts.end()));
  auto& [counts, merged, pose_count] = *tally_;
  merged.clear();
  merged.reserve(counts.size() + contacts.size());
  auto known = counts.begin();
  for (const Contact& contact : contacts) {
    for (; known != counts.end() && known->pair < contact; ++known) merged.push_back(*known);
    const bool is_known = known != counts.end() && known->pair == contact;
    merged.push_back({contact, is_known ? (known++)->poses + 1 : 1});
  }
  merged.insert(merged.end(), known, counts.end());
  std::swap(counts, merged);
  ++pose_count;
}

std::uint32_t ContactTally::pose_count() const { return tally_->pose_count; }

std::vector<Contact> ContactTally::in_share_of_poses(double share) const {
  std::vector<Contact> pairs;
  const double pose_count = tally_->pose_count;
  // A quotient is rounded like the literal: 55 of 100 poses are a share of 0.55.
  for (const Tally::Count& count : tally_->counts)
    if (count.poses / pose_count >= share) pairs.push_back(count.pair);
  return pairs;
}

}  // namespace pelt
