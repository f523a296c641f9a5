#include <pelt/self.hpp>

#include "base/require.hpp"
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

}  // namespace pelt
