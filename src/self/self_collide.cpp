#include <pelt/self.hpp>

#include "base/assert.hpp"
#include "base/require.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_filter.hpp"
#include "self/self_tree.hpp"

#include <algorithm>
#include <utility>

namespace pelt {
namespace {

bool is_filter_of(const SelfFilter& filter, const Pose& pose) {
  return &filter.model().detail() == &pose.model().detail();
}

}  // namespace

SelfStats self_collide(Pose& pose, const SelfFilter& filter, Scratch& scratch,
                       std::vector<Contact>& contacts, const Limits& limits) {
  detail::require(is_filter_of(filter, pose), "self_collide: the filter is of another model");
  const SelfStats stats = detail::self_collide_tree(pose.detail().posed_tree(), filter.detail(),
                                                    nullptr, scratch.detail(), limits.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

SelfStats self_collide(Pose& pose, SelfTracker& tracker, Scratch& scratch,
                       std::vector<Contact>& contacts, const Limits& limits) {
  detail::SelfTrack& track = tracker.detail();
  detail::require(is_filter_of(track.filter, pose),
                  "self_collide: the tracker is of another model");
  const SelfStats stats =
      detail::self_collide_tree(pose.detail().posed_tree(), track.filter.detail(), &track,
                                scratch.detail(), limits.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo self_intersects(Pose& pose, const SelfFilter& filter, Scratch& scratch) {
  detail::require(is_filter_of(filter, pose), "self_intersects: the filter is of another model");
  const SelfStats stats = detail::self_collide_tree(pose.detail().posed_tree(), filter.detail(),
                                                    nullptr, scratch.detail(), 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

namespace {

SelfMovingStats search(const Motion& motion, const SelfFilter& filter, Scratch& scratch,
                       const MovingOptions& options) {
  const detail::Step step = detail::step_of(motion);
  detail::require(&filter.model().detail() == &motion.from.model().detail(),
                  "self_collide: the filter is of another model");
  return detail::self_collide_moving_tree(step.tree(), filter.detail(), scratch.detail(), options);
}

}  // namespace

SelfMovingStats& SelfMovingStats::operator+=(const SelfMovingStats& other) {
  MovingStats::operator+=(other);
  left_out += other.left_out;
  return *this;
}

SelfMovingStats self_collide(const Motion& motion, const SelfFilter& filter, Scratch& scratch,
                             std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const SelfMovingStats stats = search(motion, filter, scratch, options);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo self_intersects(const Motion& motion, const SelfFilter& filter, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return search(motion, filter, scratch, options);
  });
}

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
