/// The queries of a pose, and of a motion, against itself.

#include <pelt/self.hpp>

#include "base/assert.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_filter.hpp"
#include "self/self_tree.hpp"

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

}  // namespace pelt
